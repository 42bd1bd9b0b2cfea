use super::double_double_filter;
use crate::dyadic::{Dyadic, DyadicVector};
use crate::kernel::sphere::ScaledRay;
use crate::kernel::{Kernel, Limits, Prepared, Tier, Window};
use crate::number::{ROOT_OF_UNIT, TINY, U};
use crate::root::{Root, rounded};
use crate::shape::{Ray, Triangle};
use crate::vector::Vector;

/// Möller–Trumbore by signs, with limits that say what rounding may have changed; that is
/// decided in twice the digits or else exactly. Edges are part of the triangle, so a closed
/// mesh has no leak, and a ray exactly through an edge meets both of its triangles. t is good
/// to √u of itself at least, mostly to an ulp.
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
///    number, adds less than 64 [`TINY`] times (1 + M + S). Where a sum or a product
///    overflows, a volume may be infinite with the wrong sign. Those of M (M + S) are at most
///    24 of it, and those of S M² 6: if 32 times as much is finite, nothing has; if not, the
///    limit is infinite. Comparisons are written so that this is open.
///
/// The ray's line misses if two of the three volumes have certain opposite signs, and
/// hits if all three have one certain sign; their sum, the determinant, has it too.
pub struct Adaptive;

impl Kernel<Triangle<f64>, f64> for Adaptive {
    const NAME: &'static str = "adaptive exact";
    type Prepared = Prepared;

    #[inline(always)]
    fn prepare(ray: &Ray<f64>) -> Prepared {
        Prepared::new(ray)
    }

    #[inline(always)]
    fn intersect(triangle: &Triangle<f64>, ray: &Prepared, min_t: f64) -> Option<f64> {
        decided(triangle, ray, min_t).0
    }
}

/// The answer, and what had the last word: the filter with limits of this ray, or what it
/// leaves open to.
#[inline(always)]
pub fn decided(triangle: &Triangle<f64>, ray: &Prepared, min_t: f64) -> (Option<f64>, Tier) {
    let scaled = &ray.scaled;
    let window = Window::new(scaled.scale(min_t));
    let limits = limits(
        size(triangle),
        (scaled.ray.origin - triangle.corners[0]).largest(),
    );
    if let Some(answer) = filtered(triangle, scaled, &window, &limits) {
        return (answer, Tier::SemiStatic);
    }
    if let Some(answer) = double_double_filter(triangle, scaled, &window) {
        return (answer, Tier::DoubleDouble);
    }
    (rounded(exact(triangle, &ray.given, min_t)), Tier::Exact)
}

/// The largest component of an edge from the first corner, rounded as kernels round it.
#[inline(always)]
pub fn size(triangle: &Triangle<f64>) -> f64 {
    let [a, b, c] = triangle.corners;
    (b - a).largest().max((c - a).largest())
}

/// For rays whose origin is up to `away` from the first corner, in each component, and all
/// triangles whose edges from there have components up to `size`. What has a sign is a volume.
#[inline(always)]
pub fn limits(size: f64, away: f64) -> Limits {
    // The 256u in two steps: no sum or product that is bounded exceeds 32 times these.
    let of_size = 32.0 * size;
    let error = |product: f64, lost: f64| 8.0 * U * product + 64.0 * TINY * (1.0 + lost);
    let good = 2.0 / ROOT_OF_UNIT;
    Limits {
        sign: error(of_size * (size + away), size + away),
        divisor: good * error(of_size * size, size),
        dividend: good * error(of_size * away * size, size + size * away),
    }
}

/// The answer, or `None` if rounding might have changed it.
///
/// A hit has three sure volumes, and a t that is good to √u, for both its parts are to ½√u.
#[inline(always)]
pub fn filtered(
    triangle: &Triangle<f64>,
    scaled: &ScaledRay<f64>,
    window: &Window,
    limits: &Limits,
) -> Option<Option<f64>> {
    let ([a, b, c], d) = (triangle.corners, scaled.ray.direction);
    let (e1, e2, s) = (b - a, c - a, scaled.ray.origin - a);
    let bound = limits.sign;
    let p = d.cross(e2);
    let determinant = e1.dot(p);
    let side = 1f64.copysign(determinant);
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
    match are_sure && is_good {
        true => window.answer(volume / determinant, scaled),
        false => None,
    }
}

/// The answer by exact signs. Edges and corners belong to the triangle: a ray exactly through
/// one hits, whichever of its triangles is asked.
#[cold]
#[inline(never)]
pub fn exact(triangle: &Triangle<f64>, ray: &Ray<f64>, min_t: f64) -> Option<Root> {
    let finite = |vector: Vector<f64>| vector.array().into_iter().all(f64::is_finite);
    let points = finite(ray.origin) && triangle.corners.into_iter().all(finite);
    if !(points && finite(ray.direction) && min_t.is_finite()) {
        return None;
    }
    let (e, d) = (
        DyadicVector::of(ray.origin),
        DyadicVector::of(ray.direction),
    );
    let [a, b, c] = triangle
        .corners
        .map(|corner| &DyadicVector::of(corner) - &e);
    let b_cross_c = b.cross(&c);
    let (u, v, w) = (d.dot(&b_cross_c), d.dot(&c.cross(&a)), d.dot(&a.cross(&b)));
    let signs = [u.sign(), v.sign(), w.sign()];
    if signs.contains(&1) && signs.contains(&-1) {
        return None;
    }
    // a·(b × c) = t d·((b − a) × (c − a)), and the latter is u + v + w: 0 if the ray lies in
    // the triangle's plane or the triangle has no area, neither of which is a hit.
    let (volume, determinant) = (a.dot(&b_cross_c), &(&u + &v) + &w);
    let beyond = &volume - &(&Dyadic::of(min_t) * &determinant);
    if determinant.sign() == 0 || beyond.sign() * determinant.sign() < 0 {
        return None;
    }
    Some(Root::fraction(volume, determinant))
}
