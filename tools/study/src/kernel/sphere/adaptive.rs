use super::haines::Scaled;
use crate::dyadic::{Dyadic, DyadicVector};
use crate::kernel::Kernel;
use crate::kernel::adaptive::Prepared;
use crate::number::Real;
use crate::root::{Root, rounded};
use crate::shape::{Ray, Sphere};
use crate::vector::Vector;

/// Haines et al., scaled, with an error bound beside each number that decides something;
/// what a bound leaves open is decided exactly. Hit or miss is never wrong, and t is
/// good to √u of itself at least, mostly to an ulp.
///
/// # Why the filter is right
///
/// With u the unit roundoff, 1 ≤ |d|∞ < 2, f = e − c and hats on what is computed
/// (Shewchuk's style, *Discrete Comput. Geom.* 18, 1997; γₙ ≈ n u):
///
/// 1. |f̂ − f| ≤ u|f|, so h = d·f is off by 4u|d||f|, h/a by 8u|f|/|d|, and
///    l = f − (h/a) d by 12u|f| =: ε at most, every rounding counted.
/// 2. r² − |l|² is off by 2|l|ε + ε² + 3u|l|² + 2u(r² + |l|²) at most. Of that, 24u|l||f|
///    ≤ 12 (√u |l|² + u√u |f|²), since 2xy ≤ x² + y²; the rest is less than
///    4 (√u (|l|² + r²) + u√u |f|²) for both types. Hence E = 16 (√u (|l|² + r²) +
///    u√u |f|²): no root is needed to bound the error of a root's argument.
/// 3. q = |h| + √(a (r² − |l|²)) is off by a (12u r|f| + 72u²|f|²) / root and 4u|d||f| at
///    most, root being that of q, |l| ≤ r, |d| < 3.5; c = |f|² − r² by 8u (|f|² + r²).
///    Where twice the first is below √u q, and the last below ½√u c, both roots c/q and
///    q/a are good to √u: what is further than 4√u from `min_t` is on its side of it.
/// 4. What underflows adds less than [`Real::TINY`] times 64 to each, and that is in the
///    bounds. What overflows makes a bound infinite or a number NaN, and either is left
///    open.
pub struct Adaptive;

impl<F: Real> Kernel<Sphere<F>, F> for Adaptive {
    const NAME: &'static str = "adaptive exact";
    type Prepared = Prepared<F>;

    #[inline(always)]
    fn prepare(ray: &Ray<F>) -> Prepared<F> {
        Prepared::new(ray)
    }

    #[inline(always)]
    fn intersect(sphere: &Sphere<F>, ray: &Prepared<F>, min_t: F) -> Option<F> {
        match filtered(sphere, &ray.scaled, min_t) {
            Some(answer) => answer,
            None => rounded(exact(sphere, &ray.given, min_t)),
        }
    }
}

/// The answer, or `None` if rounding might have changed it.
#[inline(always)]
pub fn filtered<F: Real>(sphere: &Sphere<F>, scaled: &Scaled<F>, min_t: F) -> Option<Option<F>> {
    let (u, root_u) = (F::UNIT_ROUNDOFF, F::ROOT_OF_UNIT);
    let underflow = F::of(64.0) * F::TINY;
    let d = scaled.ray.direction;
    let f = scaled.ray.origin - sphere.center;
    let (a, h, f_square) = (d.dot(d), d.dot(f), f.dot(f));
    let l = f - d * (h / a);
    let (l_square, r_square) = (l.dot(l), sphere.radius * sphere.radius);
    let within = r_square - l_square;
    let bound = F::of(16.0) * root_u * (l_square + r_square + u * f_square) + underflow;
    if within < -bound {
        return Some(None);
    }
    if !(within > bound) {
        return None;
    }
    let root = (a * within).sqrt();
    let q = h.abs() + root;
    let size = F::of(1.74) * f.largest();
    let q_error = F::of(24.0) * u * a * size * (sphere.radius + F::of(6.0) * u * size)
        + F::of(28.0) * u * size * root;
    if !(q_error < root_u * q * root) {
        return None;
    }
    let c = f_square - r_square;
    let by_c = || {
        let is_good = c.abs() > F::of(16.0) * root_u * (f_square + r_square);
        is_good.then(|| c / q)
    };
    let m = scaled.scale(min_t);
    let is_ahead = h < F::ZERO;
    let near = if is_ahead { by_c()? } else { -(q / a) };
    let t = match is_beyond(near, m)? {
        true => near,
        false => {
            let far = if is_ahead { q / a } else { -by_c()? };
            if !is_beyond(far, m)? {
                return Some(None);
            }
            far
        }
    };
    let t = scaled.unscale(t);
    t.is_finite().then_some(Some(t))
}

/// Whether the true root is not before m, if a t that is good to √u tells.
#[inline(always)]
fn is_beyond<F: Real>(t: F, m: F) -> Option<bool> {
    let margin = F::of(4.0) * F::ROOT_OF_UNIT * t.abs().max(m.abs()) + F::TINY;
    ((t - m).abs() > margin).then_some(t > m)
}

/// The answer by exact signs.
#[cold]
#[inline(never)]
pub fn exact<F: Real>(sphere: &Sphere<F>, ray: &Ray<F>, min_t: F) -> Option<Root> {
    let finite = |vector: Vector<F>| vector.array().into_iter().all(F::is_finite);
    let points = finite(ray.origin) && finite(ray.direction) && finite(sphere.center);
    if !(points && sphere.radius.is_finite() && min_t.is_finite()) {
        return None;
    }
    let f = &DyadicVector::of(ray.origin) - &DyadicVector::of(sphere.center);
    let (d, m, r) = (
        DyadicVector::of(ray.direction),
        Dyadic::of(min_t),
        Dyadic::of(sphere.radius),
    );
    let (a, h) = (d.dot(&d), d.dot(&f));
    let c = &f.dot(&f) - &(&r * &r);
    // |f + m d|² − r², and how fast it changes there.
    let onward = &(&a * &m) + &h;
    let outside = &(&(&onward + &h) * &m) + &c;
    let discriminant = &(&h * &h) - &(&a * &c);
    let is_near = match outside.sign() {
        _ if a.sign() == 0 => return None,
        0 => return Some(Root::fraction(m, Dyadic::of(1.0))),
        1 if onward.sign() >= 0 || discriminant.sign() < 0 => return None,
        sign => sign > 0,
    };
    let sign = if is_near { -1 } else { 1 };
    Some(Root::quadratic(-h, sign, discriminant, a))
}
