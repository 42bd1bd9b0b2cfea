//! Counts leaks and double hits: from inside a closed convex mesh, a ray should hit the surface
//! exactly once, in whatever direction it goes.

use crate::contestants::Contestant;
use crate::question::{Data, Question};
use crate::random::Random;
use crate::result::MeshTally;
use crate::shape::{Ray, Triangle};
use crate::vector::Vector;

/// Casts rays at edges or vertices with one kernel. The rays are the same for all kernels with
/// the same type of data.
pub fn of_kernel(
    kernel: &Contestant<Triangle<f64>>,
    aim: Aim,
    rays: usize,
    seed: u64,
) -> MeshTally {
    let mut random = Random::new(seed, &format!("mesh {aim:?} {}", kernel.data.name()));
    let mut tally = MeshTally {
        kernel: kernel.name,
        numbers: kernel.numbers,
        aimed_at: if aim == Aim::Edge { "edge" } else { "vertex" },
        rays: rays as u64,
        leaks: 0,
        double_hits: 0,
    };
    for _ in 0..rays {
        let ball = Ball::new(&mut random, kernel.data);
        let ray = ball.ray(&mut random, aim);
        let question = |face: &Triangle<f64>| Question::new(*face, ray.origin, ray.direction);
        let asked = ball.triangles.iter().map(question);
        let met = asked.filter_map(|asked| (kernel.answer)(&asked)).count();
        tally.leaks += u64::from(met == 0);
        tally.double_hits += u64::from(met > 1);
    }
    tally
}

/// Where a ray is aimed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Aim {
    /// At a random point on an edge, as nearly as rounding allows.
    Edge,
    /// At a corner: the direction is the corner minus the origin, rounded.
    Vertex,
}

impl Aim {
    /// All aims.
    pub const BOTH: [Aim; 2] = [Aim::Edge, Aim::Vertex];
}

/// An octahedron's faces, each divided into four and projected to the unit sphere. Four faces meet
/// at the octahedron's own corners, and six at every other vertex.
fn sphere() -> Vec<[Vector<f64>; 3]> {
    let ring = [(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0)];
    let ring = ring.map(|(x, y)| Vector::new(x, y, 0.0));
    let [up, down] = [1.0, -1.0].map(|z| Vector::new(0.0, 0.0, z));
    let side = |at: usize| [ring[at], ring[(at + 1) % 4]];
    let upper = (0..4).map(side).map(|[p, q]| [p, q, up]);
    let lower = (0..4).map(side).map(|[p, q]| [q, p, down]);
    // p + q is bit for bit the same as q + p, so neighbours share the new vertex exactly.
    let between = |p: Vector<f64>, q: Vector<f64>| {
        let middle = p + q;
        middle * (1.0 / middle.dot(middle).sqrt())
    };
    let cut = |[a, b, c]: [Vector<f64>; 3]| {
        let (ab, bc, ca) = (between(a, b), between(b, c), between(c, a));
        [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]
    };
    upper.chain(lower).flat_map(cut).collect()
}

/// Stride and offset of the triangles in [`sphere`] whose three vertices have valence 6, the
/// usual valence in meshes.
const VALENCE_SIX: (usize, usize) = (4, 3);

/// A closed convex mesh with coordinates rounded to `data`.
pub struct Ball {
    /// Its faces.
    pub triangles: Vec<Triangle<f64>>,
    middle: Vector<f64>,
    data: Data,
}

impl Ball {
    /// A random ellipsoid at a random place.
    pub fn new(random: &mut Random, data: Data) -> Ball {
        let (x, middle) = (random.unit(), random.unit());
        let y = random.unit_across(x);
        let [x, y, z] = [x, y, x.cross(y)].map(|axis| axis * random.within(0.5, 2.0));
        let place = |p: Vector<f64>| rounded(middle + x * p.x + y * p.y + z * p.z, data);
        let triangles = sphere().into_iter().map(|face| Triangle {
            corners: face.map(place),
        });
        Ball {
            triangles: triangles.collect(),
            middle,
            data,
        }
    }

    /// A ray from inside the mesh, aimed at an edge or a corner.
    pub fn ray(&self, random: &mut Random, aim: Aim) -> Ray<f64> {
        let round = |vector| rounded(vector, self.data);
        let origin = round(self.middle + random.unit() * random.within(0.0, 0.2));
        let (step, first) = VALENCE_SIX;
        let at = random.below(self.triangles.len() / step) * step + first;
        let [a, b, _] = self.triangles[at].corners;
        let target = match aim {
            Aim::Edge => round(a + (b - a) * random.within(0.0, 1.0)),
            Aim::Vertex => a,
        };
        let direction = round(target - origin);
        Ray { origin, direction }
    }
}

fn rounded(vector: Vector<f64>, data: Data) -> Vector<f64> {
    vector.map(|x| data.round(x))
}
