//! Planes: (e + t d − p) · n = 0.
//!
//! The exact kernel is [`ShiftedOrigin`] with a filter. What the filter leaves uncertain is decided
//! exactly, so hit or miss is never wrong. The relative error of t is at most √u.
//!
//! # Why the filter is right
//!
//! A dot product of three terms has an error of at most γ₃ ≤ 4u times P, the sum of the terms'
//! magnitudes (Higham, *Accuracy and Stability*, 2nd ed., §3.1). Together with the rounding of
//! p − e, this is below 5u P, so 8u P is safe. P is at most three times the product of the
//! largest components, and the largest component of the scaled direction is below 2. Underflow
//! adds less than 64 times [`TINY`]. Overflow makes a limit infinite or a number NaN; then the
//! filter does not decide.

use super::short::{are_short, at_least};
use super::{Filtered, Kernel, Limits, ScaledQuery};
use crate::dyadic::Dyadic;
use crate::number::{Real, TINY, U};
use crate::root::Root;
use crate::shape::{Plane, Ray};
use crate::vector::{Ring, Vector};

/// The implicit form (Marschner & Shirley, §4.4.3), with the origin shifted to the plane's
/// point first, as in the assignment's reference: t = n·(p − e) / n·d. Far from the world's
/// origin, the expanded form n·p − n·e would subtract two large numbers. Subtracting nearby
/// points first has little or no rounding error (Sterbenz's lemma), and the products are then
/// as small as the scene.
pub struct ShiftedOrigin;

impl<F: Real> Kernel<Plane<F>, F> for ShiftedOrigin {
    const NAME: &'static str = "shifted origin";
    type PreparedRay = Ray<F>;

    #[inline(always)]
    fn prepare(ray: &Ray<F>) -> Ray<F> {
        *ray
    }

    #[inline(always)]
    fn intersect(plane: &Plane<F>, ray: &Ray<F>, min_t: F) -> Option<F> {
        let along_normal = plane.normal.dot(ray.direction);
        if along_normal == F::zero() {
            return None;
        }
        let t = plane.normal.dot(plane.point - ray.origin) / along_normal;
        (t >= min_t).then_some(t)
    }
}

impl Filtered for Plane<f64> {
    fn anchor(&self) -> Vector<f64> {
        self.point
    }

    #[inline(always)]
    fn limits(&self, away: f64, _: f64, accuracy: f64) -> Limits {
        let size = 3.0 * self.normal.largest();
        let good = |largest: f64| 2.0 / accuracy * (8.0 * U * (size * largest) + 64.0 * TINY);
        Limits {
            sign: 0.0,
            divisor: good(2.0),
            dividend: good(away),
        }
    }

    #[inline(always)]
    fn filtered(&self, query: &ScaledQuery, limits: &Limits) -> Option<Option<f64>> {
        let height = self.normal.dot(self.point - query.scaled.ray.origin);
        at_height(self.normal, height, query, limits)
    }

    fn short(&self, ray: &Ray<f64>, min_t: f64) -> Option<Option<f64>> {
        let fraction = self.short_fraction(ray)?;
        Some(at_least(min_t, fraction))
    }

    #[cold]
    #[inline(never)]
    fn exact(&self, ray: &Ray<f64>, min_t: f64) -> Option<Root> {
        let is_finite = self.normal.is_finite() && self.point.is_finite();
        if !(is_finite && ray.is_finite() && min_t.is_finite()) {
            return None;
        }
        let [height, down] = fraction(self.exact_vectors(ray));
        if down.sign() == 0 {
            return None;
        }
        let beyond = height.clone() - Dyadic::of(min_t) * down.clone();
        (beyond.sign() * down.sign() >= 0).then(|| Root::fraction(height, down))
    }

    fn short_fraction(&self, ray: &Ray<f64>) -> Option<[f64; 2]> {
        let [n, p, e, d] = self.vectors(ray);
        let is_short = are_short([p, e]) && are_short([d]) && are_short([n]);
        is_short.then(|| fraction([n, p, e, d]))
    }

    fn exact_hit(&self, ray: &Ray<f64>, _: f64) -> Root {
        let [height, down] = fraction(self.exact_vectors(ray));
        Root::fraction(height, down)
    }
}

impl Plane<f64> {
    fn vectors(&self, ray: &Ray<f64>) -> [Vector<f64>; 4] {
        [self.normal, self.point, ray.origin, ray.direction]
    }

    fn exact_vectors(&self, ray: &Ray<f64>) -> [Vector<Dyadic>; 4] {
        self.vectors(ray).map(|vector| vector.map(Dyadic::of))
    }
}

/// n·(p − e) and n·d.
fn fraction<F: Ring>([n, p, e, d]: [Vector<F>; 4]) -> [F; 2] {
    [n.clone().dot(p - e), n.dot(d)]
}

/// The filter, given n·(p − e).
#[inline(always)]
pub fn at_height(
    normal: Vector<f64>,
    height: f64,
    query: &ScaledQuery,
    limits: &Limits,
) -> Option<Option<f64>> {
    let along = normal.dot(query.scaled.ray.direction);
    match along.abs() > limits.divisor && height.abs() > limits.dividend {
        true => query.answer(height / along),
        false => None,
    }
}
