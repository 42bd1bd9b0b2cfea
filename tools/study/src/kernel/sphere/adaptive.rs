//! [`super::Haines`] with a filter. What the filter leaves uncertain is decided exactly, so hit
//! or miss is never wrong. The relative error of t is at most √u, and mostly about an ulp.
//!
//! # Why the filter is right
//!
//! Let u be the unit roundoff, 1 ≤ |d|∞ < 2, and f = e − c. Hats mark computed values, and γₙ ≈
//! n u (in the style of Shewchuk, *Discrete Comput. Geom.* 18, 1997):
//!
//! 1. |f̂ − f| ≤ u|f|, so the error of h = d·f is at most 4u|d||f|, that of h/a at most
//!    8u|f|/|d|, and that of l = f − (h/a) d at most ε := 12u|f|, with every rounding counted.
//! 2. The error of r² − |l|² is at most 2|l|ε + ε² + 3u|l|² + 2u(r² + |l|²). Of this, 24u|l||f|
//!    ≤ 12 (√u |l|² + u√u |f|²), because 2xy ≤ x² + y². The rest is less than 4 (√u (|l|² + r²) +
//!    u√u |f|²). Hence E = 16 (√u (|l|² + r²) + u√u |f|²) is a bound that needs no square
//!    root. If |l|² ≤ 2r², then E ≤ 48√u r² + 16u√u |f|², which is less than [`Limits::sign`].
//!    If |l|² > 2r², then r² − |l|² < −|l|²/2 and E ≤ 24√u |l|² + `sign`/2, where the first
//!    term is below half of |l|²/2. So a value below −`sign` is also below −E, and the ray
//!    misses.
//! 3. The error of q = |h| + √(a (r² − |l|²)) is at most a (16u r|f| + 96u²|f|²) / root plus
//!    4u|d||f|, where root is the square root in q, |l| ≤ r, |l| ≤ |f| and |d| < 3.5: of the
//!    error of r² − |l|², 3u|l|² + 2u(r² + |l|²) is at most 7u r|f| + 2u(r² − |l|²), and the last
//!    term counts as a rounding of the final operations. The error of c =
//!    |f|² − r² is at most 8u (|f|² + r²). If twice the first error is below √u q, and the
//!    second below ½√u c, then both roots c/q and q/a have a relative error of at most √u. The
//!    first condition holds if 32u a |f| (r + 6u|f|) + 28u |f| root < √u q root. Because q ≥
//!    root, it suffices that 64√u |f| (r + 6u|f|) and 3136u |f|² are below root²/a = r² − |l|²
//!    (a ≥ 1); this gives [`Limits::divisor`]. c is the dividend. The same holds for any other
//!    accuracy in place of √u, with 64u/accuracy and 3136u²/accuracy².
//! 4. Underflow adds less than 64 times [`TINY`] to each, which the limits include. Overflow
//!    makes a limit infinite or a number NaN; then the filter does not decide. In q, the product
//!    a (r² − |l|²) is below 12r². If it overflows, so does 64r², and all limits but the dividend's
//!    are infinite.

use crate::dyadic::Dyadic;
use crate::kernel::{Filtered, Limits, ScaledQuery};
use crate::number::{ROOT_OF_UNIT, TINY, U};
use crate::root::Root;
use crate::shape::{Ray, Sphere};
use crate::vector::Vector;

impl Filtered for Sphere<f64> {
    fn anchor(&self) -> Vector<f64> {
        self.center
    }

    #[inline(always)]
    fn limits(&self, _: f64, distance: f64, accuracy: f64) -> Limits {
        let r = self.radius.abs();
        let (square, r_square) = (distance * distance, r * r);
        let underflow = 128.0 * TINY;
        // 64 r² is computed first, so that overflow shows up in the limit.
        let sign =
            ROOT_OF_UNIT * (64.0 * r_square) + 32.0 * ROOT_OF_UNIT * (U * square) + underflow;
        let lost = U / accuracy;
        Limits {
            sign,
            divisor: 64.0 * lost * distance * (r + 6.0 * U * distance)
                + 4096.0 * lost * lost * square
                + sign,
            dividend: 16.0 * lost * (square + r_square) + underflow,
        }
    }

    #[inline(always)]
    fn filtered(&self, query: &ScaledQuery, limits: &Limits) -> Option<Option<f64>> {
        let f = query.scaled.ray.origin - self.center;
        let r_square = self.radius * self.radius;
        nearest_root(f, r_square, || f.dot(f) - r_square, query, limits)
    }

    #[cold]
    #[inline(never)]
    fn exact(&self, ray: &Ray<f64>, min_t: f64) -> Option<Root> {
        let is_finite = self.center.is_finite() && self.radius.is_finite();
        if !(is_finite && ray.is_finite() && min_t.is_finite()) {
            return None;
        }
        let f = ray.origin.map(Dyadic::of) - self.center.map(Dyadic::of);
        let (d, m, r) = (
            ray.direction.map(Dyadic::of),
            Dyadic::of(min_t),
            Dyadic::of(self.radius),
        );
        let (a, h) = (d.clone().squared(), d.dot(f.clone()));
        let c = f.squared() - r.squared();
        // |f + m d|² − r² at t = m, and half its derivative there.
        let onward = a.clone() * m.clone() + h.clone();
        let outside = (onward.clone() + h.clone()) * m.clone() + c.clone();
        let discriminant = h.clone().squared() - a.clone() * c;
        let is_near = match outside.sign() {
            _ if a.sign() == 0 => return None,
            0 => return Some(Root::fraction(m, Dyadic::of(1.0))),
            1 if onward.sign() >= 0 || discriminant.sign() < 0 => return None,
            sign => sign > 0,
        };
        let sign = if is_near { -1 } else { 1 };
        Some(Root::quadratic(-h, sign, discriminant, a))
    }
}

/// Bound on the length of a vector with components up to `largest`.
#[inline(always)]
pub fn at_most(largest: f64) -> f64 {
    1.74 * largest
}

/// The filter, given f, r² and c.
#[inline(always)]
pub(super) fn nearest_root(
    f: Vector<f64>,
    r_square: f64,
    c: impl FnOnce() -> f64,
    query: &ScaledQuery,
    limits: &Limits,
) -> Option<Option<f64>> {
    let d = query.scaled.ray.direction;
    let (a, h) = (d.dot(d), d.dot(f));
    let l = f - d * (h / a);
    let within = r_square - l.dot(l);
    if within < -(limits.sign) {
        return Some(None);
    }
    if !(within > limits.divisor) {
        return None;
    }
    let c = c();
    if !(c.abs() > limits.dividend) {
        return None;
    }
    // The signs of c and h are certain: c by its limit, and h because for c > 0 a root needs h²
    // > a c.
    let (is_ahead, is_inside) = (h < 0.0, c < 0.0);
    if !is_ahead && !is_inside {
        // Both roots are negative, and therefore below `min_t`.
        return Some(None);
    }
    let q = h.abs() + (a * within).sqrt();
    // From inside, the near root is negative. From outside, it may be below `min_t`.
    let t = match is_ahead {
        true if !is_inside && c / q >= query.before => c / q,
        true => q / a,
        false => -(c / q),
    };
    query.answer(t)
}
