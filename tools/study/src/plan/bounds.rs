//! How far rounding can have moved what the exact caster says of a hit.
//!
//! Which part is met, and which is first, it never gets wrong. Its t it proves to
//! [`PROVEN_T`], for every ray and every scene, before any bound of this file is looked at.
//! Who wants more asks [`of_t`] about a hit: a forward error bound in the manner of Higham,
//! *Accuracy and Stability of Numerical Algorithms*, 2nd ed., §§2–3, counted to first order
//! with constants that are rounded up and leave room for the rest. [`of_normal`] says what
//! an error of t does to the normal.
//!
//! Such bounds are relative. They hold where no number underflows or overflows, and that is
//! proven first, from the sizes of what is multiplied ([`IN_RANGE`]); elsewhere nothing is
//! certain, and exact arithmetic answers.

use crate::cast::world::Primitive;
use crate::kernel::sphere::ScaledRay;
use crate::number::{ROOT_OF_UNIT, U};
use crate::shape::{Plane, Sphere, Triangle};
use crate::vector::Vector;

/// The exact caster's t is off by no more than this part of itself: twice the √u that
/// [`crate::kernel::sphere::Adaptive`] and the others prove, which leaves room for what
/// divides and scales it last.
pub const PROVEN_T: f64 = 2.0 * ROOT_OF_UNIT;

/// Sizes between 2^−150 and 2^150. No product of this file has more than five factors, so
/// that what underflows, 2^−1074 each, is far below the roundings of what does not.
const IN_RANGE: std::ops::RangeInclusive<f64> = 7.1e-46..=1.4e45;

/// How far rounding turns a vector that is made unit length.
pub const OF_UNIT: f64 = 8.0 * U;

/// An error as a part of the true number, given what was computed of both.
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

/// How far t may be off, as a part of itself, for a hit that the filters decided; what they
/// left open was computed better. Infinite where nothing is certain.
pub fn of_t(shape: &Primitive, ray: &ScaledRay<f64>) -> f64 {
    match shape {
        Primitive::Sphere(shape) => of_sphere(shape, ray),
        Primitive::Plane(shape) => of_plane(shape, ray),
        Primitive::Triangle(shape) => of_triangle(shape, ray),
    }
}

/// With 1 ≤ |d|∞ < 2, f = e − c and l from the centre to the line:
///
/// 1. l is off by λ = 16u|f|, of which [`crate::kernel::sphere::Adaptive`] counts 12u|f|.
/// 2. s² = r² − |l|² is off by ω = 2(r + λ)λ + λ² + 8u(r + λ)², hence s by σ = ω/(s + ŝ) ≤
///    ω/s; and by √ω at most, however flat the ray grazes.
/// 3. t|d| is q or c/q with q = |h|/|d| + s, which is off by λ + σ and six roundings; c =
///    |f|² − r² by χ = 8u|f|² + 3ur². q ≥ √|c| always: q² ≥ h²/|d|² + s² = |f|² + r² −
///    2|l|², which |l| ≤ r or |l| ≤ |f| makes ≥ |c|.
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

/// A dot product of three terms is off by 8u of the sum of its terms' magnitudes, the
/// subtraction p − e included (as in [`crate::kernel::plane::Adaptive`]).
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

/// With M the largest component of two edges, S that of e − a and |d|∞ < 2: Möller–Trumbore's
/// determinant is off by 96u M², and t times it by 54u S M² (cf.
/// [`crate::kernel::triangle::Adaptive`]).
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

/// How far a sphere's normal may be turned, in radians, if its t is off by this part of
/// itself. (e − c) + t d is off by u|e − c|, by what t is off times |t d| ≤ |e − c| + r, and
/// by roundings of either; over r, that turns the normal.
pub fn of_normal(sphere: &Sphere<f64>, away: f64, of_t: f64) -> f64 {
    // A vector is no longer than √3 of its largest component.
    let (away, r) = (1.74 * away, sphere.radius);
    let moved = of_t * (away + r) + 4.0 * U * (away + r);
    match are_in_range([r]) {
        true => 1.1 * part(moved, r) + OF_UNIT,
        false => f64::INFINITY,
    }
}

/// A triangle's unit normal, and how far it may be turned. Edges are brought near 1 by powers
/// of two: rounded by u each, they have components below 2, so that each component of their
/// product is off by 33u at most, and the product by 58u.
pub fn normal_of(triangle: &Triangle<f64>) -> (Vector<f64>, f64) {
    let outward = triangle.outward_near_one();
    let turned = 1.1 * part(64.0 * U, outward.largest()) + OF_UNIT;
    (outward.unit(), turned)
}
