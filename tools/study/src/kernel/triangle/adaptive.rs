use super::exact::exact;
use super::twice::twice;
use crate::kernel::Kernel;
use crate::kernel::adaptive::Prepared;
use crate::kernel::sphere::Scaled;
use crate::number::Real;
use crate::root::rounded;
use crate::shape::{Ray, Triangle};

/// Möller–Trumbore by signs, with one error bound; what it leaves open is decided in twice
/// the digits or else exactly. Edges are part of the triangle, so a closed mesh has no
/// leak, and a ray exactly through an edge meets both of its triangles. t is good to √u of
/// itself at least, mostly to an ulp.
///
/// # Why the filter is right
///
/// With u the unit roundoff, |d|∞ < 2, S = |s|∞, M the larger of |e₁|∞ and |e₂|∞, which
/// come rounded by u each (Shewchuk's style, *Discrete Comput. Geom.* 18, 1997):
///
/// 1. A component of d × e₂ is at most 4M and off by 12uM; a dot product of that with e₁
///    is off by 3 M (4uM + 12uM) from its factors and 3u × 12 M² from its own roundings:
///    84u M². Likewise d·(s × e₁) and s·(d × e₂) by 84u S M, and e₂·(s × e₁) by 48u S M².
/// 2. The third volume, determinant − u − v, is off by the sum of these and of two
///    roundings: 108u M² + 216u S M. So 256u M (M + S) bounds every volume's error, with
///    its own roundings, and 256u S M² that of t times the determinant.
/// 3. What underflows, in products of components below 1/u of the smallest normal
///    number, adds less than 64 [`Real::TINY`] times (1 + M + S). Where a sum or a
///    product overflows, a volume may be infinite with the wrong sign. Those of M (M + S)
///    are at most 24 of it, and those of S M² 6: if 32 times as much is finite, nothing
///    has; if not, the bound is infinite. Comparisons are written so that this is open.
///
/// The ray's line misses if two of the three volumes have certain opposite signs, and
/// hits if all three have one certain sign; their sum, the determinant, has it too.
pub struct Adaptive;

impl<F: Real> Kernel<Triangle<F>, F> for Adaptive {
    const NAME: &'static str = "adaptive exact";
    type Prepared = Prepared<F>;

    #[inline(always)]
    fn prepare(ray: &Ray<F>) -> Prepared<F> {
        Prepared::new(ray)
    }

    #[inline(always)]
    fn intersect(triangle: &Triangle<F>, ray: &Prepared<F>, min_t: F) -> Option<F> {
        match filtered(triangle, &ray.scaled, min_t) {
            Some(answer) => answer,
            None => left_open(triangle, ray, min_t),
        }
    }
}

/// What the filter leaves open: in twice the digits, and only then in all.
#[cold]
#[inline(never)]
fn left_open<F: Real>(triangle: &Triangle<F>, ray: &Prepared<F>, min_t: F) -> Option<F> {
    twice(triangle, &ray.scaled, min_t)
        .unwrap_or_else(|| rounded(exact(triangle, &ray.given, min_t)))
}

/// How far rounding may have moved what decides: see the head of [`Adaptive`].
#[derive(Clone, Copy, Debug)]
pub(super) struct Budget<F> {
    /// Of each of the three volumes, and of their sum.
    pub of_volumes: F,
    /// Of the determinant alone.
    pub of_determinant: F,
    /// Of t times the determinant.
    pub of_t: F,
}

impl<F: Real> Budget<F> {
    /// For triangles whose edges have components up to `size`, and rays whose origin is
    /// up to `away` from a corner, in each component.
    #[inline(always)]
    pub fn new(size: F, away: F) -> Budget<F> {
        let underflow = F::of(64.0) * F::TINY;
        // The 256u in two steps: no sum or product that is bounded exceeds 32 times these.
        let (of_size, share) = (F::of(32.0) * size, F::of(8.0) * F::UNIT_ROUNDOFF);
        let error = |product: F, lost: F| share * product + underflow * (F::ONE + lost);
        Budget {
            of_volumes: error(of_size * (size + away), size + away),
            of_determinant: error(of_size * size, size),
            of_t: error(of_size * away * size, size + size * away),
        }
    }
}

/// The answer, or `None` if rounding might have changed it.
#[inline(always)]
pub fn filtered<F: Real>(
    triangle: &Triangle<F>,
    scaled: &Scaled<F>,
    min_t: F,
) -> Option<Option<F>> {
    let ([a, b, c], d) = (triangle.corners, scaled.ray.direction);
    let (e1, e2, s) = (b - a, c - a, scaled.ray.origin - a);
    let budget = Budget::new(e1.largest().max(e2.largest()), s.largest());
    let bound = budget.of_volumes;
    let p = d.cross(e2);
    let determinant = e1.dot(p);
    if !(determinant.abs() > bound) {
        return None;
    }
    let side = F::ONE.copysign(determinant);
    let determinant = determinant.abs();
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
    if !(u > bound && v > bound && w > bound) {
        return None;
    }

    // t − m = (volume − m determinant) / determinant.
    let (volume, m) = (e2.dot(q) * side, scaled.scale(min_t));
    let beyond = volume - m * determinant;
    let beyond_error = budget.of_t + F::of(2.0) * m.abs() * bound;
    if !(beyond.abs() > beyond_error && beyond.is_finite()) {
        return None;
    }
    if beyond < F::ZERO {
        return Some(None);
    }
    let half = F::of(0.5) * F::ROOT_OF_UNIT;
    if !(half * volume.abs() > budget.of_t && half * determinant > budget.of_determinant) {
        return None;
    }
    let t = scaled.unscale(volume / determinant).max(min_t);
    t.is_finite().then_some(Some(t))
}
