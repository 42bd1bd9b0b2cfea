//! Eight shapes at a time: which of them may a ray in `f32` meet?
//!
//! Numbers that lie side by side are computed side by side, by compilers of any machine:
//! four `f32` are one register everywhere, where `f64` are two. That, and not the shorter
//! digits, is what makes `f32` fast. What is let through is asked by a kernel, which
//! decides; so the test here need only lose nothing, and is too generous for that.

use crate::number::Real;
use crate::shape::{Plane, Ray, Sphere, Triangle};
use crate::vector::Vector;

/// How many.
pub const EIGHT: usize = 8;

/// A number of each.
type Row = [f32; EIGHT];

/// Which can be sifted eight at a time.
pub trait Sifted: Copy {
    /// Eight of them, number by number.
    type Rows;
    /// Eight, or fewer, of which the last is then repeated.
    fn rows(shapes: &[Self]) -> Self::Rows;
    /// Of each, negative only if the ray's line passes it.
    fn margins(rows: &Self::Rows, ray: &Ray<f32>) -> Row;
}

fn row<S: Copy>(shapes: &[S], number: impl Fn(&S) -> f32) -> Row {
    std::array::from_fn(|at| number(&shapes[at.min(shapes.len() - 1)]))
}

/// Eight vectors, component by component.
#[derive(Clone)]
pub struct Vectors([Row; 3]);

impl Vectors {
    fn of<S: Copy>(shapes: &[S], vector: impl Fn(&S) -> Vector<f32>) -> Vectors {
        Vectors([0, 1, 2].map(|axis| row(shapes, |shape| vector(shape).array()[axis])))
    }

    #[inline(always)]
    fn at(&self, lane: usize) -> Vector<f32> {
        let [x, y, z] = &self.0;
        Vector::new(x[lane], y[lane], z[lane])
    }
}

/// Centres and squares of radii.
#[derive(Clone)]
pub struct Spheres {
    centers: Vectors,
    squares: Row,
}

impl Sifted for Sphere<f32> {
    type Rows = Spheres;

    fn rows(shapes: &[Sphere<f32>]) -> Spheres {
        Spheres {
            centers: Vectors::of(shapes, |sphere| sphere.center),
            squares: row(shapes, |sphere| sphere.radius * sphere.radius),
        }
    }

    /// r² − |l|² as Haines et al. have it. With λ = 16u|f|, which bounds the error of l
    /// (see [`crate::kernel::sphere::Adaptive`]), that of |l|² is less than 2rλ + λ² ≤
    /// r²/1000 + 1001 λ², and 1001 λ² < 1e-9 |f|².
    #[inline(always)]
    fn margins(rows: &Spheres, ray: &Ray<f32>) -> Row {
        let d = ray.direction;
        let by_square = 1.0 / d.dot(d);
        std::array::from_fn(|lane| {
            let f = ray.origin - rows.centers.at(lane);
            let l = f - d * (d.dot(f) * by_square);
            1.001 * rows.squares[lane] + 1e-9 * f.dot(f) - l.dot(l)
        })
    }
}

/// First corners, and the edges that leave them.
#[derive(Clone)]
pub struct Triangles {
    corners: Vectors,
    edges: [Vectors; 2],
    /// The largest component of both.
    sizes: Row,
}

impl Sifted for Triangle<f32> {
    type Rows = Triangles;

    fn rows(shapes: &[Triangle<f32>]) -> Triangles {
        let edge = |at: usize| move |t: &Triangle<f32>| t.corners[at] - t.corners[0];
        let size = |t: &Triangle<f32>| Real::max(edge(1)(t).largest(), edge(2)(t).largest());
        Triangles {
            corners: Vectors::of(shapes, |triangle| triangle.corners[0]),
            edges: [1, 2].map(|at| Vectors::of(shapes, edge(at))),
            sizes: row(shapes, size),
        }
    }

    /// The least of Möller & Trumbore's three volumes, with twice the 48u S M |d|∞ that
    /// rounding may take from it ([`crate::plan::bounds`] counts them), and as much for
    /// the sum of two.
    #[inline(always)]
    fn margins(rows: &Triangles, ray: &Ray<f32>) -> Row {
        let d = ray.direction;
        let slack = 200.0 * f32::UNIT_ROUNDOFF * d.largest();
        std::array::from_fn(|lane| {
            let [e1, e2] = [rows.edges[0].at(lane), rows.edges[1].at(lane)];
            let s = ray.origin - rows.corners.at(lane);
            let (p, q) = (d.cross(e2), s.cross(e1));
            let determinant = e1.dot(p);
            let side = 1f32.copysign(determinant);
            let (u, v) = (s.dot(p) * side, d.dot(q) * side);
            let size = rows.sizes[lane];
            let spare = slack * size * (size + s.largest());
            let least = |a: f32, b: f32| if a < b { a } else { b };
            least(least(u, v), determinant.abs() - u - v) + spare
        })
    }
}

impl Sifted for Plane<f32> {
    type Rows = ();
    fn rows(_: &[Plane<f32>]) {}
    /// A plane is passed by none.
    #[inline(always)]
    fn margins((): &(), _: &Ray<f32>) -> Row {
        [0.0; EIGHT]
    }
}
