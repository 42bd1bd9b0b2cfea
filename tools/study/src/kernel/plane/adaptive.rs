use crate::dyadic::{Dyadic, DyadicVector};
use crate::kernel::Kernel;
use crate::number::Real;
use crate::root::{Root, rounded};
use crate::shape::{Plane, Ray};
use crate::vector::Vector;

/// Shifted, with error bounds, and exact where they leave a decision open. Hit or miss
/// is never wrong, and t is good to √u of itself at least.
///
/// # Why the filter is right
///
/// A dot product of three terms is off by γ₃ ≤ 4u times the sum P of the terms'
/// magnitudes (Higham, *Accuracy and Stability*, 2nd ed., §3.1), with p − e rounded
/// before by 5u P. P is computed with the same relative error, which 8u covers. What
/// underflows adds less than 64 times [`Real::TINY`]; m times the error of n·d is taken
/// with m. What overflows makes a bound infinite or NaN, and that decides nothing.
pub struct Adaptive;

impl<F: Real> Kernel<Plane<F>, F> for Adaptive {
    const NAME: &'static str = "adaptive exact";
    type Prepared = Ray<F>;

    #[inline(always)]
    fn prepare(ray: &Ray<F>) -> Ray<F> {
        *ray
    }

    #[inline(always)]
    fn intersect(plane: &Plane<F>, ray: &Ray<F>, min_t: F) -> Option<F> {
        match filtered(plane, ray, min_t) {
            Some(answer) => answer,
            None => rounded(exact(plane, ray, min_t)),
        }
    }
}

/// The answer, or `None` if rounding might have changed it.
#[inline(always)]
pub fn filtered<F: Real>(plane: &Plane<F>, ray: &Ray<F>, m: F) -> Option<Option<F>> {
    let (n, d, w) = (plane.normal, ray.direction, plane.point - ray.origin);
    let error = |v: Vector<F>| {
        F::of(8.0) * F::UNIT_ROUNDOFF * n.map(F::abs).dot(v.map(F::abs)) + F::of(64.0) * F::TINY
    };
    let (down, height) = (n.dot(d), n.dot(w));
    let (down_error, height_error) = (error(d), error(w));
    // t − m = (height − m down) / down.
    let beyond = height - m * down;
    let beyond_error = height_error
        + F::of(2.0) * m.abs() * down_error
        + F::of(2.0) * F::UNIT_ROUNDOFF * beyond.abs();
    if !(down.abs() > down_error && beyond.abs() > beyond_error) {
        return None;
    }
    if (beyond > F::ZERO) != (down > F::ZERO) {
        return Some(None);
    }
    let half = F::of(0.5) * F::ROOT_OF_UNIT;
    if !(half * down.abs() > down_error && half * height.abs() > height_error) {
        return None;
    }
    let t = (height / down).max(m);
    t.is_finite().then_some(Some(t))
}

/// The answer by exact signs.
#[cold]
#[inline(never)]
pub fn exact<F: Real>(plane: &Plane<F>, ray: &Ray<F>, min_t: F) -> Option<Root> {
    let vectors = [plane.normal, plane.point, ray.origin, ray.direction];
    let finite = |vector: Vector<F>| vector.array().into_iter().all(F::is_finite);
    if !(vectors.into_iter().all(finite) && min_t.is_finite()) {
        return None;
    }
    let n = DyadicVector::of(plane.normal);
    let down = n.dot(&DyadicVector::of(ray.direction));
    let height = n.dot(&(&DyadicVector::of(plane.point) - &DyadicVector::of(ray.origin)));
    let beyond = &height - &(&Dyadic::of(min_t) * &down);
    if down.sign() == 0 || beyond.sign() * down.sign() < 0 {
        return None;
    }
    Some(Root::fraction(height, down))
}
