//! Bounds on the rounding errors of a hit by the exact caster.
//!
//! The exact caster is never wrong about which parts a ray hits, or which of them comes first. For
//! every ray and every scene, its t is proven to [`PROVEN_T`](super::world::PROVEN_T).
//! [`of_normal`] bounds the error of a normal, in the manner of Higham, *Accuracy and Stability of
//! Numerical Algorithms*, 2nd ed., §§2–3. It counts first-order terms, with constants rounded up to
//! cover the rest. [`required_t`] turns this around: how accurate must t be?
//!
//! These bounds are relative, so they hold only if no number underflows or overflows. This is
//! checked first, from the sizes of the factors (`IN_RANGE`). Outside this range nothing is
//! certain, and the hit is computed exactly.

use super::world::Primitive;
use crate::number::U;
use crate::shape::{Sphere, Triangle};

/// Sizes from 2^−150 to 2^150. No product in this file has more than five factors, so
/// underflow, 2^−1074 each time, is far below the other rounding errors.
const IN_RANGE: std::ops::RangeInclusive<f64> = 7.1e-46..=1.4e45;

/// Largest angle by which normalising a vector turns it.
const OF_UNIT: f64 = 8.0 * U;

/// The relative error, from a bound on the absolute error and the computed magnitude; infinite
/// if the error is too large for that.
fn part(error: f64, computed: f64) -> f64 {
    match error < 0.5 * computed {
        true => error / (computed - error),
        false => f64::INFINITY,
    }
}

/// Whether bounds are valid for factors of these sizes.
pub fn are_in_range(sizes: impl IntoIterator<Item = f64>) -> bool {
    sizes.into_iter().all(|size| IN_RANGE.contains(&size))
}

/// The bounds below are for small errors.
const COARSEST: f64 = 0.1;

/// The largest relative error of t with which every hit has the requested accuracy, or
/// [`COARSEST`]; 0 if no error is small enough. `distance` is the largest distance of an origin from
/// the shape's anchor.
pub fn required_t(shape: &Primitive, distance: f64, accuracy: f64) -> f64 {
    let accuracy = accuracy.min(COARSEST);
    let of_t = match shape {
        // See `of_sphere`, where t's error counts 1.1 times.
        Primitive::Sphere(sphere) => accuracy / (1.3 * (1.0 + distance / sphere.radius)),
        _ => accuracy,
    };
    let of_t = of_t.min(accuracy);
    match of_normal(shape, distance, of_t) <= accuracy {
        true => of_t,
        false => 0.0,
    }
}

/// Largest error of a normal in radians, given the origin's distance from the shape's anchor and
/// the relative error of t.
pub fn of_normal(shape: &Primitive, distance: f64, of_t: f64) -> f64 {
    match shape {
        Primitive::Plane(_) => OF_UNIT,
        Primitive::Triangle(triangle) => of_triangle(triangle),
        Primitive::Sphere(sphere) => of_sphere(sphere, distance, of_t),
    }
}

/// The error of (e − c) + t d is u|e − c|, plus the error of t times |t d| ≤ |e − c| + r, plus
/// roundings of both. Divided by r, it is the angle.
fn of_sphere(sphere: &Sphere<f64>, distance: f64, of_t: f64) -> f64 {
    let r = sphere.radius;
    let moved = of_t * (distance + r) + 4.0 * U * (distance + r);
    match are_in_range([r]) {
        true => 1.1 * part(moved, r) + OF_UNIT,
        false => f64::INFINITY,
    }
}

/// The edges are scaled near 1 by powers of two and have components below 2, rounded by u each. So
/// the error of each component of their cross product is at most 33u, and that of the product at
/// most 58u.
fn of_triangle(triangle: &Triangle<f64>) -> f64 {
    let outward = triangle.outward_near_one();
    // Edges that overflow have no normal. `largest` may overlook a component that is NaN.
    match outward.is_finite() {
        true => 1.1 * part(64.0 * U, outward.largest()) + OF_UNIT,
        false => f64::INFINITY,
    }
}
