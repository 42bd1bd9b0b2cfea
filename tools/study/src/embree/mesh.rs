//! Meshes with `f32` coordinates, so that every caster gets exactly the same mesh.

use std::path::Path;

use crate::cast::world::vector;
use crate::vector::{Vector, around};

/// A triangle mesh.
pub struct Mesh {
    /// The name in the table.
    pub name: &'static str,
    /// The positions of each triangle's corners.
    pub triangles: Vec<[[f32; 3]; 3]>,
}

/// One of the assignment's meshes, moved and scaled to fit the unit sphere.
pub fn of_assignment(name: &'static str) -> Mesh {
    let folder = "../../assignments/ray_casting/scenes/meshes";
    let file = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join(folder)
        .join(format!("{name}.obj"));
    let read = pinhole::mesh::read(&file).expect("the mesh is committed");
    let corners = || read.iter().flatten().map(|corner| vector(*corner));
    let [low, high] = around(corners().map(|corner| [corner; 2])).expect("it has a face");
    let middle = (low + high) * 0.5;
    let away = corners().map(|corner| (corner - middle).squared());
    let radius = away.fold(0.0, f64::max).sqrt();
    let fitted = |corner| (vector(corner) - middle).map(|x| (x / radius) as f32);
    let faces = read.iter();
    Mesh {
        name,
        triangles: faces
            .map(|face| face.map(|corner| fitted(corner).array()))
            .collect(),
    }
}

/// A bumpy sphere: a square of 2n × 2n cells, folded to an octahedron, with two triangles in each
/// cell.
pub fn ball(n: u32) -> Mesh {
    let hill = |x: f64, y: f64, z: f64| {
        0.85 + 0.1 * (5.0 * x + 3.0 * y).sin() * (4.0 * z).cos() + 0.02 * (40.0 * (x - y + z)).sin()
    };
    let corner = |i: u32, j: u32| {
        let [x, y] = [i, j].map(|index| f64::from(index) / f64::from(n) - 1.0);
        let z = 1.0 - x.abs() - y.abs();
        let [x, y] = match z < 0.0 {
            true => [(1.0 - y.abs()).copysign(x), (1.0 - x.abs()).copysign(y)],
            false => [x, y],
        };
        let Vector { x, y, z } = Vector::new(x, y, z).unit();
        [x, y, z].map(|number| (number * hill(x, y, z)) as f32)
    };
    let mut triangles = Vec::new();
    for (i, j) in (0..2 * n).flat_map(|i| (0..2 * n).map(move |j| (i, j))) {
        let [p, q, r] = [corner(i, j), corner(i + 1, j), corner(i, j + 1)];
        triangles.extend([[p, q, r], [q, corner(i + 1, j + 1), r]]);
    }
    let name = "ball";
    Mesh { name, triangles }
}
