//! Eight shapes at a time: which of them may a ray in `f32` meet?
//!
//! Four `f32` are one register on any machine, where `f64` are two. That, and not the
//! shorter digits, is what makes `f32` fast, and it is written out: what a compiler does of
//! its own accord with numbers side by side, it may leave undone when a file is split.
//! What is let through is asked by a kernel, which decides; so the test here need only
//! lose nothing, and is too generous for that.

use wide::f32x8;

use crate::number::Real;
use crate::shape::{Plane, Ray, Sphere, Triangle};
use crate::vector::Vector;

/// How many.
pub const EIGHT: usize = 8;

/// Which can be sifted eight at a time.
pub trait Sifted: Copy {
    /// Eight of them, number by number.
    type Rows;
    /// Eight, or fewer, of which the last is then repeated.
    fn rows(shapes: &[Self]) -> Self::Rows;
    /// A bit for each that the ray's line may meet.
    fn passed(rows: &Self::Rows, ray: &Ray<f32>) -> u32;
}

fn row<S>(shapes: &[S], number: impl Fn(&S) -> f32) -> f32x8 {
    let numbers: [f32; EIGHT] = std::array::from_fn(|at| number(&shapes[at.min(shapes.len() - 1)]));
    f32x8::new(numbers)
}

/// Eight vectors, component by component.
fn vectors<S>(shapes: &[S], vector: impl Fn(&S) -> Vector<f32>) -> Vector<f32x8> {
    let axis = |axis: usize| row(shapes, |shape| vector(shape).array()[axis]);
    Vector::new(axis(0), axis(1), axis(2))
}

/// A bit for each that is not below 0. What overflowed is NaN, of which nothing is sure.
#[inline(always)]
fn not_negative(margins: f32x8) -> u32 {
    !margins.simd_lt(f32x8::splat(0.0)).to_bitmask() & ((1 << EIGHT) - 1)
}

/// Centres and squares of radii.
#[derive(Clone)]
pub struct Spheres {
    centers: Vector<f32x8>,
    squares: f32x8,
}

impl Sifted for Sphere<f32> {
    type Rows = Spheres;

    fn rows(shapes: &[Sphere<f32>]) -> Spheres {
        Spheres {
            centers: vectors(shapes, |sphere| sphere.center),
            squares: row(shapes, |sphere| sphere.radius * sphere.radius),
        }
    }

    /// r² − |l|² as Haines et al. have it. With λ = 16u|f|, which bounds the error of l
    /// (see [`crate::kernel::sphere::Adaptive`]), that of |l|² is less than 2rλ + λ² ≤
    /// r²/1000 + 1001 λ², and 1001 λ² < 1e-9 |f|².
    #[inline(always)]
    fn passed(rows: &Spheres, ray: &Ray<f32>) -> u32 {
        let by_square = f32x8::splat(1.0 / ray.direction.dot(ray.direction));
        let d = ray.direction.map(f32x8::splat);
        let f = ray.origin.map(f32x8::splat) - rows.centers;
        let l = f - d * (d.dot(f) * by_square);
        let spare = f32x8::splat(1e-9) * f.dot(f);
        let margin = f32x8::splat(1.001) * rows.squares + spare - l.dot(l);
        not_negative(margin)
    }
}

/// First corners, and the edges that leave them.
#[derive(Clone)]
pub struct Triangles {
    corners: Vector<f32x8>,
    edges: [Vector<f32x8>; 2],
    /// The largest component of both.
    sizes: f32x8,
}

impl Sifted for Triangle<f32> {
    type Rows = Triangles;

    fn rows(shapes: &[Triangle<f32>]) -> Triangles {
        let edge = |at: usize| move |t: &Triangle<f32>| t.corners[at] - t.corners[0];
        let size = |t: &Triangle<f32>| Real::max(edge(1)(t).largest(), edge(2)(t).largest());
        Triangles {
            corners: vectors(shapes, |triangle| triangle.corners[0]),
            edges: [1, 2].map(|at| vectors(shapes, edge(at))),
            sizes: row(shapes, size),
        }
    }

    /// The least of Möller & Trumbore's three volumes, with twice the 48u S M |d|∞ that
    /// rounding may take from it ([`crate::plan::bounds`] counts them), and as much for
    /// the sum of two.
    #[inline(always)]
    fn passed(rows: &Triangles, ray: &Ray<f32>) -> u32 {
        let slack = f32x8::splat(200.0 * f32::UNIT_ROUNDOFF * ray.direction.largest());
        let d = ray.direction.map(f32x8::splat);
        let [e1, e2] = rows.edges;
        let s = ray.origin.map(f32x8::splat) - rows.corners;
        let (p, q) = (d.cross(e2), s.cross(e1));
        let determinant = e1.dot(p);
        let side = determinant & f32x8::splat(-0.0);
        let (u, v) = (s.dot(p) ^ side, d.dot(q) ^ side);
        let [x, y, z] = s.map(f32x8::abs).array();
        let spare = slack * rows.sizes * (rows.sizes + x.fast_max(y).fast_max(z));
        let least = u.fast_min(v).fast_min(determinant.abs() - u - v);
        not_negative(least + spare)
    }
}

impl Sifted for Plane<f32> {
    type Rows = ();
    fn rows(_: &[Plane<f32>]) {}
    /// A plane is passed by none.
    #[inline(always)]
    fn passed((): &(), _: &Ray<f32>) -> u32 {
        (1 << EIGHT) - 1
    }
}
