//! Möller–Trumbore by signs of volumes, with a filter. What the filter leaves uncertain is
//! decided exactly. Edges are part of the triangle, so a closed mesh has no leak, and a ray exactly
//! through an edge hits both of its triangles. The relative error of t is at most √u, and mostly
//! about an ulp.
//!
//! # Why the filter is right
//!
//! Let u be the unit roundoff, |d|∞ < 2, S = |s|∞, and M the larger of |e₁|∞ and |e₂|∞. The
//! edges are rounded by u each (in the style of Shewchuk, *Discrete Comput. Geom.* 18, 1997):
//!
//! 1. A component of d × e₂ is at most 4M, with an error of at most 12uM. The error of its dot
//!    product with e₁ is at most 3 M (4uM + 12uM) from the factors plus 3u × 12 M² from its own
//!    roundings: 84u M². Likewise, the error of d·(s × e₁) and s·(d × e₂) is at most 84u S M,
//!    and that of e₂·(s × e₁) at most 48u S M².
//! 2. The error of the third volume, determinant − u − v, is at most the sum of these errors
//!    and of two roundings: 108u M² + 216u S M. So 256u M (M + S) bounds the error of every
//!    volume, including the roundings of the bound itself, and 256u S M² that of t times the
//!    determinant.
//! 3. Underflow, in products of components below 1/u of the smallest normal number, adds less
//!    than 64 [`TINY`] times (1 + M + S). If a sum or a product overflows, a volume may be
//!    infinite with the wrong sign. The volumes are at most 24 M (M + S), and t times the
//!    determinant is at most 6 S M². If 32 times these bounds is finite, nothing has
//!    overflowed; if not, the limit is infinite, and comparisons are written so that the filter
//!    then does not decide.
//!
//! The ray's line misses if two of the three volumes certainly have opposite signs. It hits if
//! all three certainly have the same sign; their sum, the determinant, then has it too.

use crate::dyadic::Dyadic;
use crate::kernel::short::{are_short, at_least};
use crate::kernel::{Filtered, Limits, ScaledQuery};
use crate::number::{TINY, U};
use crate::root::Root;
use crate::shape::{Ray, Triangle};
use crate::vector::{Ring, Vector};

impl Filtered for Triangle<f64> {
    fn anchor(&self) -> Vector<f64> {
        self.corners[0]
    }

    #[inline(always)]
    fn limits(&self, away: f64, _: f64, accuracy: f64) -> Limits {
        let [a, b, c] = self.corners;
        let size = (b - a).largest().max((c - a).largest());
        // 256u is 32 times 8u: no sum or product in the kernel exceeds 32 times these sizes, so
        // that overflow shows up in the limit.
        let of_size = 32.0 * size;
        let error = |product: f64, lost: f64| 8.0 * U * product + 64.0 * TINY * (1.0 + lost);
        let good = 2.0 / accuracy;
        Limits {
            sign: error(of_size * (size + away), size + away),
            divisor: good * error(of_size * size, size),
            dividend: good * error(of_size * away * size, size + size * away),
        }
    }

    /// The filter: the answer, or `None` if rounding might have changed it.
    ///
    /// For a hit, all three volumes have a certain sign, and the relative error of t is at most √u,
    /// because that of its dividend and of its divisor is at most ½√u.
    #[inline(always)]
    fn filtered(&self, query: &ScaledQuery, limits: &Limits) -> Option<Option<f64>> {
        let ([a, b, c], d) = (self.corners, query.scaled.ray.direction);
        let (e1, e2, s) = (b - a, c - a, query.scaled.ray.origin - a);
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
            true => query.answer(volume / determinant),
            false => None,
        }
    }

    fn short(&self, ray: &Ray<f64>, min_t: f64) -> Option<Option<f64>> {
        let sign = |x: &f64| i32::from(*x > 0.0) - i32::from(*x < 0.0);
        let fraction = || if_not_beside(self.vectors(ray), sign);
        let answer = || fraction().and_then(|fraction| at_least(min_t, fraction));
        self.is_short(ray).then(answer)
    }

    /// The answer by exact arithmetic. Edges and corners belong to the triangle: a ray exactly
    /// through one hits every triangle that shares it.
    #[cold]
    #[inline(never)]
    fn exact(&self, ray: &Ray<f64>, min_t: f64) -> Option<Root> {
        let is_finite = self.corners.into_iter().all(Vector::is_finite);
        if !(is_finite && ray.is_finite() && min_t.is_finite()) {
            return None;
        }
        let [volume, determinant] = if_not_beside(self.exact_vectors(ray), Dyadic::sign)?;
        // The determinant is 0 if the ray lies in the triangle's plane or the triangle has no area,
        // neither of which is a hit.
        let beyond = volume.clone() - Dyadic::of(min_t) * determinant.clone();
        if determinant.sign() == 0 || beyond.sign() * determinant.sign() < 0 {
            return None;
        }
        Some(Root::fraction(volume, determinant))
    }

    fn short_fraction(&self, ray: &Ray<f64>) -> Option<[f64; 2]> {
        self.is_short(ray).then(|| fraction(self.vectors(ray)))
    }

    fn exact_hit(&self, ray: &Ray<f64>, _: f64) -> Root {
        let [height, down] = fraction(self.exact_vectors(ray));
        Root::fraction(height, down)
    }
}

impl Triangle<f64> {
    fn vectors(&self, ray: &Ray<f64>) -> [Vector<f64>; 5] {
        let [a, b, c] = self.corners;
        [a, b, c, ray.origin, ray.direction]
    }

    fn exact_vectors(&self, ray: &Ray<f64>) -> [Vector<Dyadic>; 5] {
        self.vectors(ray).map(|vector| vector.map(Dyadic::of))
    }

    fn is_short(&self, ray: &Ray<f64>) -> bool {
        let [a, b, c, e, d] = self.vectors(ray);
        are_short([a, b, c, e]) && are_short([d])
    }
}

/// n·(a − e) and n·d with n = (b − a) × (c − a). Leaving out on which side of each edge the ray
/// passes saves more than half of the multiplications.
fn fraction<F: Ring>([a, b, c, e, d]: [Vector<F>; 5]) -> [F; 2] {
    let normal = (b - a.clone()).cross(c - a.clone());
    [normal.clone().dot(a - e), normal.dot(d)]
}

/// t times the determinant, and the determinant, which is the sum of three volumes; `None` if two of
/// the volumes have opposite signs, so that the ray's line misses.
fn if_not_beside<F: Ring>([a, b, c, e, d]: [Vector<F>; 5], sign: fn(&F) -> i32) -> Option<[F; 2]> {
    let [a, b, c] = [a, b, c].map(|corner| corner - e.clone());
    let b_cross_c = b.clone().cross(c.clone());
    let u = d.clone().dot(b_cross_c.clone());
    let v = d.clone().dot(c.cross(a.clone()));
    let w = d.dot(a.clone().cross(b));
    let signs = [sign(&u), sign(&v), sign(&w)];
    let is_beside = signs.contains(&1) && signs.contains(&-1);
    // a·(b × c) = t d·((b − a) × (c − a)), and the latter is u + v + w.
    (!is_beside).then(|| [a.dot(b_cross_c), u + v + w])
}
