//! Closed meshes: a ray from inside meets the surface exactly once, wherever it goes.

use crate::question::{Data, Question};
use crate::random::Random;
use crate::shape::{Ray, Triangle};
use crate::vector::Vector;

/// Where a ray is aimed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Aim {
    /// At a random point of an edge, as nearly as rounding lets it.
    Edge,
    /// At a corner, exactly: the direction is the corner minus the origin, rounded.
    Vertex,
}

/// A ray and all triangles around it, numbers rounded to a type.
pub struct Inside {
    /// A closed, convex mesh.
    pub triangles: Vec<Triangle<f64>>,
    /// From inside.
    pub ray: Ray<f64>,
}

impl Inside {
    /// The question to one of the triangles.
    pub fn question(&self, shape: Triangle<f64>) -> Question<Triangle<f64>> {
        Question { shape, ray: self.ray, min_t: 0.0 }
    }
}

/// The faces of an octahedron over its corners ±x, ±y, ±z.
const OCTAHEDRON: [[usize; 3]; 8] = [
    [0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5],
];

/// A ray inside an octahedron of random shape and place, aimed at an edge or a corner.
pub fn inside(random: &mut Random, aim: Aim, data: Data) -> Inside {
    let round = |vector: Vector<f64>| vector.map(|x| data.round(x));
    let (x, middle) = (random.unit(), random.unit());
    let y = random.unit_across(x);
    let z = x.cross(y);
    let corners = [x, x * -1.0, y, y * -1.0, z, z * -1.0]
        .map(|axis| round(middle + axis * random.within(0.5, 2.0)));
    let origin = round(middle + random.unit() * random.within(0.0, 0.2));
    let triangles = OCTAHEDRON.map(|face| Triangle { corners: face.map(|at| corners[at]) });
    let [a, b, _] = triangles[random.below(8)].corners;
    let target = match aim {
        Aim::Edge => round(a + (b - a) * random.within(0.0, 1.0)),
        Aim::Vertex => a,
    };
    let direction = round(target - origin);
    Inside { triangles: triangles.to_vec(), ray: Ray { origin, direction } }
}
