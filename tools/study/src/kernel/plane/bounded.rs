use crate::kernel::sphere::Scaled;
use crate::kernel::{Limits, Window};
use crate::number::Real;
use crate::shape::Plane;

/// For rays whose origin is up to `away` from the plane's point, in each component. The
/// sum of a dot product's magnitudes, which bounds its error in [`super::Adaptive`], is at
/// most three times the product of the largest components; of the scaled direction that
/// is below 2.
pub fn limits<F: Real>(plane: &Plane<F>, away: F) -> Limits<F> {
    let error = |largest: F| {
        let sum = F::of(3.0) * plane.normal.largest() * largest;
        F::of(8.0) * F::UNIT_ROUNDOFF * sum + F::of(64.0) * F::TINY
    };
    let good = F::of(2.0) / F::ROOT_OF_UNIT;
    Limits {
        sign: F::ZERO,
        divisor: good * error(F::of(2.0)),
        dividend: good * error(away),
    }
}

/// The answer of [`super::filtered`], or, more often than there, `None`.
#[inline(always)]
pub fn bounded<F: Real>(
    plane: &Plane<F>,
    scaled: &Scaled<F>,
    window: &Window<F>,
    limits: &Limits<F>,
) -> Option<Option<F>> {
    let ray = &scaled.ray;
    let along = plane.normal.dot(ray.direction);
    let height = plane.normal.dot(plane.point - ray.origin);
    if !(along.abs() > limits.divisor && height.abs() > limits.dividend) {
        return None;
    }
    let t = height / along;
    if t < window.before {
        return Some(None);
    }
    let t = (t > window.after).then(|| scaled.unscale(t))?;
    t.is_finite().then_some(Some(t))
}
