//! Bounds on the rounding errors of a hit by the exact caster.
//!
//! The exact caster is never wrong about which parts a ray hits, or which of them comes first. For
//! every ray and every scene, its t is proven to [`PROVEN_T`] without any bound of this file. For
//! more accuracy, [`of_t`] computes a forward error bound of one hit, in the manner of Higham,
//! *Accuracy and Stability of Numerical Algorithms*, 2nd ed., §§2–3. It counts first-order terms,
//! with constants rounded up to cover the rest. [`of_normal`] bounds the error of a normal, given
//! the error of t.
//!
//! These bounds are relative, so they hold only if no number underflows or overflows. This is
//! checked first, from the sizes of the factors (`IN_RANGE`). Outside this range nothing is
//! certain, and the hit is computed exactly.

use crate::cast::world::Primitive;
use crate::kernel::sphere::ScaledRay;
use crate::number::{ROOT_OF_UNIT, U};
use crate::shape::{Plane, Sphere, Triangle};
use crate::vector::Vector;

/// Bound on the relative error of the exact caster's t: twice the √u that
/// [`crate::kernel::sphere::Adaptive`] and the others prove, which covers the final division
/// and scaling.
pub const PROVEN_T: f64 = 2.0 * ROOT_OF_UNIT;

/// Sizes from 2^−150 to 2^150. No product in this file has more than five factors, so
/// underflow, 2^−1074 each time, is far below the other rounding errors.
const IN_RANGE: std::ops::RangeInclusive<f64> = 7.1e-46..=1.4e45;

/// Largest angle by which normalising a vector turns it.
pub const OF_UNIT: f64 = 8.0 * U;

/// The relative error, from a bound on the absolute error and the computed magnitude; infinite
/// if the error is too large for that.
fn part(error: f64, computed: f64) -> f64 {
    match error < 0.5 * computed {
        true => error / (computed - error),
        false => f64::INFINITY,
    }
}

/// Σ|aᵢ||bᵢ|.
fn terms(a: Vector<f64>, b: Vector<f64>) -> f64 {
    a.map(f64::abs).dot(b.map(f64::abs))
}

fn are_in_range(sizes: impl IntoIterator<Item = f64>) -> bool {
    sizes.into_iter().all(|size| IN_RANGE.contains(&size))
}

/// Bound on the relative error of t for a hit that the filters decided; other hits have a more
/// accurate t. Infinite if nothing is certain.
pub fn of_t(shape: &Primitive, ray: &ScaledRay<f64>) -> f64 {
    match shape {
        Primitive::Sphere(shape) => of_sphere(shape, ray),
        Primitive::Plane(shape) => of_plane(shape, ray),
        Primitive::Triangle(shape) => of_triangle(shape, ray),
    }
}

/// Let 1 ≤ |d|∞ < 2, f = e − c, and l the vector from the centre to the line:
///
/// 1. The error of l is at most λ = 16u|f|, of which [`crate::kernel::sphere::Adaptive`] counts
///    12u|f|.
/// 2. The error of s² = r² − |l|² is at most ω = 2(r + λ)λ + λ² + 8u(r + λ)², and the error of s is
///    at most σ = ω/(s + ŝ) ≤ ω/s. It is also at most √ω, even for a grazing ray.
/// 3. t|d| is q or c/q with q = |h|/|d| + s. The error of q is at most λ + σ plus six
///    roundings, and that of c = |f|² − r² at most χ = 8u|f|² + 3ur². Always q ≥ √|c|, because
///    q² ≥ h²/|d|² + s² = |f|² + r² − 2|l|², which is at least |c| as |l| ≤ r and |l| ≤ |f|.
fn of_sphere(sphere: &Sphere<f64>, ScaledRay { ray, .. }: &ScaledRay<f64>) -> f64 {
    let (d, r, from_center) = (ray.direction, sphere.radius, ray.origin - sphere.center);
    if !are_in_range([from_center.largest(), r]) {
        return f64::INFINITY;
    }
    let (f_square, direction) = (from_center.dot(from_center), d.dot(d).sqrt());
    let along = d.dot(from_center) / direction;
    let l = from_center - d * (along / direction);
    let lambda = 16.0 * U * f_square.sqrt();
    let reach = r + lambda;
    let omega = 2.0 * reach * lambda + lambda * lambda + 8.0 * U * reach * reach;
    let depth = (r * r - l.dot(l) - omega).max(0.0).sqrt();
    let sigma = (omega / depth).min(omega.sqrt()) + 4.0 * U * r;
    let c = (f_square - r * r).abs();
    let q = ((along.abs() - lambda).max(0.0) + depth).max(c.sqrt());
    let chi = 8.0 * U * f_square + 3.0 * U * r * r;
    part(lambda + sigma, q) + part(chi, c) + 6.0 * U
}

/// The error of a dot product of three terms is at most 8u times the sum of its terms'
/// magnitudes, including the subtraction p − e (as in [`crate::kernel::plane::Adaptive`]).
fn of_plane(plane: &Plane<f64>, ScaledRay { ray, .. }: &ScaledRay<f64>) -> f64 {
    let (n, d, w) = (plane.normal, ray.direction, plane.point - ray.origin);
    let down = n.dot(d).abs();
    // A component of d that is 1e300 times smaller than another may have lost digits.
    if !are_in_range([n.largest(), w.largest(), down]) {
        return f64::INFINITY;
    }
    let down = part(8.0 * U * terms(n, d), down);
    let height = part(8.0 * U * terms(n, w), n.dot(w).abs());
    (down + height) * (1.0 + down) + 2.0 * U
}

/// With M the largest component of two edges, S that of e − a, and |d|∞ < 2, the error of
/// Möller–Trumbore's determinant is at most 96u M², and that of t times the determinant at most
/// 54u S M² (cf. [`crate::kernel::triangle::Adaptive`]).
fn of_triangle(triangle: &Triangle<f64>, ScaledRay { ray, .. }: &ScaledRay<f64>) -> f64 {
    let [a, b, c] = triangle.corners;
    let (e1, e2, away) = (b - a, c - a, ray.origin - a);
    let (m, s) = (e1.largest().max(e2.largest()), away.largest());
    if !are_in_range([m, s]) {
        return f64::INFINITY;
    }
    let outward = e1.cross(e2);
    let determinant = part(96.0 * U * m * m, outward.dot(ray.direction).abs());
    let volume = part(54.0 * U * s * m * m, outward.dot(away).abs());
    (determinant + volume) * (1.0 + determinant) + 3.0 * U
}

/// Largest error of a sphere's normal in radians, given the relative error of t. The error of
/// (e − c) + t d is u|e − c|, plus the error of t times |t d| ≤ |e − c| + r, plus roundings of
/// both. Divided by r, it is the angle.
pub fn of_normal(sphere: &Sphere<f64>, away: f64, of_t: f64) -> f64 {
    // A vector is at most √3 times as long as its largest component.
    let (away, r) = (1.74 * away, sphere.radius);
    let moved = of_t * (away + r) + 4.0 * U * (away + r);
    match are_in_range([r]) {
        true => 1.1 * part(moved, r) + OF_UNIT,
        false => f64::INFINITY,
    }
}

/// A triangle's unit normal, and the largest error of its angle. The edges are scaled near 1 by
/// powers of two and have components below 2, rounded by u each. So the error of each component
/// of their cross product is at most 33u, and that of the product at most 58u.
pub fn normal_of(triangle: &Triangle<f64>) -> (Vector<f64>, f64) {
    let outward = triangle.outward_near_one();
    let largest = outward.largest();
    // Edges that overflow have no normal.
    let turned = match largest.is_finite() {
        true => 1.1 * part(64.0 * U, largest) + OF_UNIT,
        false => f64::INFINITY,
    };
    (outward.unit(), turned)
}
