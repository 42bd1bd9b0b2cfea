//! Meshes with `f32` coordinates, so that every caster gets exactly the same mesh.

use std::path::Path;

use pinhole_study::cast::world::vector;
use pinhole_study::vector::{Vector, around};

/// A triangle mesh.
pub struct Mesh {
    /// The name in the table.
    pub name: String,
    /// The positions of each triangle's corners.
    pub triangles: Vec<[[f32; 3]; 3]>,
}

impl Mesh {
    fn new(name: &str, triangles: Vec<[[f32; 3]; 3]>) -> Mesh {
        let name = format!("{name}, {} triangles", triangles.len());
        Mesh { name, triangles }
    }
}

/// One of the assignment's meshes, moved and scaled to fit the unit sphere.
pub fn of_assignment(name: &str) -> Mesh {
    let folder = "../../../assignments/ray_casting/scenes/meshes";
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
    let triangles = read
        .iter()
        .map(|face| face.map(|corner| fitted(corner).array()));
    Mesh::new(name, triangles.collect())
}

/// A bumpy sphere: an octahedron whose faces are divided into n × n triangles each.
pub fn ball(n: u32) -> Mesh {
    let hill = |x: f64, y: f64, z: f64| {
        0.85 + 0.1 * (5.0 * x + 3.0 * y).sin() * (4.0 * z).cos() + 0.02 * (40.0 * (x - y + z)).sin()
    };
    let mut triangles = Vec::new();
    for face in 0..8 {
        let sign = |bit: u32| if face >> bit & 1 == 0 { 1.0 } else { -1.0 };
        let corner = |i: u32, j: u32| {
            let [x, y] = [i, j].map(|index| f64::from(index) / f64::from(n));
            let flat = Vector::new(x * sign(0), y * sign(1), (1.0 - x - y) * sign(2));
            let Vector { x, y, z } = flat * (1.0 / flat.squared().sqrt());
            [x, y, z].map(|number| (number * hill(x, y, z)) as f32)
        };
        for i in 0..n {
            for j in 0..n - i {
                let [along, across] = [corner(i, j + 1), corner(i + 1, j)];
                triangles.push([corner(i, j), along, across]);
                if j + 1 < n - i {
                    triangles.push([along, corner(i + 1, j + 1), across]);
                }
            }
        }
    }
    Mesh::new("ball", triangles)
}
