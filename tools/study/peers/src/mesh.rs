//! Meshes with `f32` coordinates, so that every caster gets exactly the same mesh.

use std::path::Path;

/// An indexed triangle mesh.
pub struct Mesh {
    /// The name in the table.
    pub name: String,
    /// The vertices' positions.
    pub corners: Vec<[f32; 3]>,
    /// The indices of each triangle's three corners.
    pub triangles: Vec<[u32; 3]>,
}

impl Mesh {
    /// The positions of each triangle's corners.
    pub fn each(&self) -> impl Iterator<Item = [[f32; 3]; 3]> {
        let corner = |at: u32| self.corners[at as usize];
        self.triangles
            .iter()
            .map(move |corners| corners.map(corner))
    }
}

/// One of the assignment's meshes, moved and scaled to fit the unit sphere.
pub fn of_assignment(name: &str) -> Mesh {
    let folder = "../../../assignments/ray_casting/scenes/meshes";
    let file = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join(folder)
        .join(name);
    let (models, _) =
        tobj::load_obj(&file, &tobj::GPU_LOAD_OPTIONS).expect("the mesh is committed");
    let (mut corners, mut triangles) = (Vec::new(), Vec::new());
    for model in models {
        let first = corners.len() as u32;
        let (points, _) = model.mesh.positions.as_chunks::<3>();
        corners.extend_from_slice(points);
        let (indices, _) = model.mesh.indices.as_chunks::<3>();
        triangles.extend(indices.iter().map(|corners| corners.map(|at| first + at)));
    }
    let ends = |axis: usize| {
        let numbers = || corners.iter().map(|point| point[axis]);
        (
            numbers().fold(f64::MAX, f64::min),
            numbers().fold(f64::MIN, f64::max),
        )
    };
    let ends = [0, 1, 2].map(ends);
    let middle = ends.map(|(low, high)| (low + high) / 2.0);
    let from_middle = |p: &[f64; 3]| [0, 1, 2].map(|axis| p[axis] - middle[axis]);
    let length = |p: [f64; 3]| p.into_iter().fold(0.0, f64::hypot);
    let radius = corners
        .iter()
        .map(|p| length(from_middle(p)))
        .fold(0.0, f64::max);
    let corners: Vec<_> = corners
        .iter()
        .map(|p| from_middle(p).map(|x| (x / radius) as f32))
        .collect();
    let name = name.trim_end_matches(".obj");
    Mesh {
        name: format!("{name}, {} triangles", triangles.len()),
        corners,
        triangles,
    }
}

/// A bumpy sphere: an octahedron whose faces are divided into n × n triangles each.
pub fn ball(n: u32) -> Mesh {
    let (mut corners, mut triangles) = (Vec::new(), Vec::new());
    let hill = |x: f64, y: f64, z: f64| {
        0.85 + 0.1 * (5.0 * x + 3.0 * y).sin() * (4.0 * z).cos() + 0.02 * (40.0 * (x - y + z)).sin()
    };
    for face in 0..8 {
        let sign = |bit: u32| if face >> bit & 1 == 0 { 1.0 } else { -1.0 };
        let first = corners.len() as u32;
        let row_begins = |row: u32| first + row * (2 * n + 3 - row) / 2;
        for i in 0..=n {
            for j in 0..=n - i {
                let [x, y] = [i, j].map(|index| f64::from(index) / f64::from(n));
                let [x, y, z] = [x * sign(0), y * sign(1), (1.0 - x - y) * sign(2)];
                let length = x.hypot(y).hypot(z);
                let [x, y, z] = [x, y, z].map(|number| number / length);
                corners.push([x, y, z].map(|number| (number * hill(x, y, z)) as f32));
                if i < n && j < n - i {
                    let (here, across) = (row_begins(i) + j, row_begins(i + 1) + j);
                    triangles.push([here, here + 1, across]);
                    if j + 1 < n - i {
                        triangles.push([here + 1, across + 1, across]);
                    }
                }
            }
        }
    }
    Mesh {
        name: format!("ball, {} triangles", triangles.len()),
        corners,
        triangles,
    }
}
