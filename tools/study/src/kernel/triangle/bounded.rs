use super::adaptive::Budget;
use crate::kernel::sphere::Scaled;
use crate::kernel::{Limits, Window};
use crate::number::Real;
use crate::shape::Triangle;

/// For rays whose origin is up to `away` from the first corner, in each component, and
/// all triangles whose edges from there have components up to `size`: the bounds of
/// [`super::Adaptive`]. What has a sign is a volume.
pub fn limits<F: Real>(size: F, away: F) -> Limits<F> {
    let budget = Budget::new(size, away);
    let good = F::of(2.0) / F::ROOT_OF_UNIT;
    Limits {
        sign: budget.of_volumes,
        divisor: good * budget.of_determinant,
        dividend: good * budget.of_t,
    }
}

/// The largest component of an edge from the first corner, rounded as kernels round it.
pub fn size<F: Real>(triangle: &Triangle<F>) -> F {
    let [a, b, c] = triangle.corners;
    (b - a).largest().max((c - a).largest())
}

/// The answer of [`super::filtered`], or, more often than there, `None`.
///
/// A miss by the signs of two volumes, as there. A hit has three sure volumes, and a t
/// that is good to √u, for both its parts are to ½√u: it is compared with `min_t` itself.
#[inline(always)]
pub fn bounded<F: Real>(
    triangle: &Triangle<F>,
    scaled: &Scaled<F>,
    window: &Window<F>,
    limits: &Limits<F>,
) -> Option<Option<F>> {
    let ([a, b, c], d) = (triangle.corners, scaled.ray.direction);
    let (e1, e2, s) = (b - a, c - a, scaled.ray.origin - a);
    let bound = limits.sign;
    let p = d.cross(e2);
    let determinant = e1.dot(p);
    let side = F::ONE.copysign(determinant);
    let determinant = determinant.abs();
    if !(determinant > bound) {
        return None;
    }
    let u = s.dot(p) * side;
    if u < -bound || u - determinant > bound {
        return Some(None);
    }
    let q = s.cross(e1);
    let v = d.dot(q) * side;
    let w = determinant - u - v;
    if v < -bound || w < -bound {
        return Some(None);
    }
    let volume = e2.dot(q) * side;
    let are_sure = u > bound && v > bound && w > bound;
    let is_good = determinant > limits.divisor && volume.abs() > limits.dividend;
    if !(are_sure && is_good) {
        return None;
    }
    let t = volume / determinant;
    if t < window.before {
        return Some(None);
    }
    let t = (t > window.after).then(|| scaled.unscale(t))?;
    t.is_finite().then_some(Some(t))
}
