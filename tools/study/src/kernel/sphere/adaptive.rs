use super::haines::ScaledRay;
use crate::dyadic::{Dyadic, DyadicVector};
use crate::kernel::{Kernel, Limits, Prepared, Tier, Window};
use crate::number::{ROOT_OF_UNIT, TINY, U};
use crate::root::{Root, rounded};
use crate::shape::{Ray, Sphere};
use crate::vector::Vector;

/// Haines et al., scaled, with limits that say what rounding may have changed; that is decided
/// exactly. Hit or miss is never wrong, and t is good to √u of itself at least, mostly to an
/// ulp.
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
///    4 (√u (|l|² + r²) + u√u |f|²). Hence E = 16 (√u (|l|² + r²) + u√u |f|²): no root is
///    needed to bound the error of a root's argument. If |l|² ≤ 2r², E ≤ 48√u r² +
///    16u√u |f|², and [`Limits::sign`] is more. If |l|² > 2r², then r² − |l|² < −|l|²/2, and
///    E ≤ 24√u |l|² + `sign`/2, of which the first is below a half of |l|²/2. So what is below
///    −`sign` is below −E: a miss.
/// 3. q = |h| + √(a (r² − |l|²)) is off by a (12u r|f| + 72u²|f|²) / root and 4u|d||f| at
///    most, root being that of q, |l| ≤ r, |d| < 3.5; c = |f|² − r² by 8u (|f|² + r²).
///    Where twice the first is below √u q, and the last below ½√u c, both roots c/q and
///    q/a are good to √u. The first holds if 24u a |f| (r + 6u|f|) + 28u |f| root <
///    √u q root. As q ≥ root, 48√u |f| (r + 6u|f|) and 3136u |f|² below root²/a = r² − |l|²
///    suffice (a ≥ 1): [`Limits::divisor`]. c is the dividend.
/// 4. What underflows adds less than [`TINY`] times 64 to each, and that is in the limits.
///    What overflows makes a limit infinite or a number NaN, and either is left open.
pub struct Adaptive;

impl Kernel<Sphere<f64>, f64> for Adaptive {
    const NAME: &'static str = "adaptive exact";
    type Prepared = Prepared;

    #[inline(always)]
    fn prepare(ray: &Ray<f64>) -> Prepared {
        Prepared::new(ray)
    }

    #[inline(always)]
    fn intersect(sphere: &Sphere<f64>, ray: &Prepared, min_t: f64) -> Option<f64> {
        decided(sphere, ray, min_t).0
    }
}

/// The answer, and what had the last word: the filter with limits of this ray, or what it
/// leaves open to.
#[inline(always)]
pub fn decided(sphere: &Sphere<f64>, ray: &Prepared, min_t: f64) -> (Option<f64>, Tier) {
    let scaled = &ray.scaled;
    let window = Window::new(scaled.scale(min_t));
    let limits = limits(sphere, (scaled.ray.origin - sphere.center).largest());
    if let Some(answer) = filtered(sphere, scaled, &window, &limits) {
        return (answer, Tier::SemiStatic);
    }
    (rounded(exact(sphere, &ray.given, min_t)), Tier::Exact)
}

/// For rays whose origin is up to `away` from the centre, in each component: |f| is at most
/// 1.74 of that.
#[inline(always)]
pub fn limits(sphere: &Sphere<f64>, away: f64) -> Limits {
    let (size, r) = (1.74 * away, sphere.radius.abs());
    let (size_square, r_square) = (size * size, r * r);
    let underflow = 128.0 * TINY;
    let sign = 64.0 * ROOT_OF_UNIT * r_square + 32.0 * ROOT_OF_UNIT * (U * size_square) + underflow;
    Limits {
        sign,
        divisor: 64.0 * ROOT_OF_UNIT * size * (r + 6.0 * U * size)
            + 4096.0 * U * size_square
            + sign,
        dividend: 16.0 * ROOT_OF_UNIT * (size_square + r_square) + underflow,
    }
}

/// The answer, or `None` if rounding might have changed it.
#[inline(always)]
pub fn filtered(
    sphere: &Sphere<f64>,
    scaled: &ScaledRay<f64>,
    window: &Window,
    limits: &Limits,
) -> Option<Option<f64>> {
    let d = scaled.ray.direction;
    let f = scaled.ray.origin - sphere.center;
    let (a, h) = (d.dot(d), d.dot(f));
    let l = f - d * (h / a);
    let r_square = sphere.radius * sphere.radius;
    let within = r_square - l.dot(l);
    if within < -(limits.sign) {
        return Some(None);
    }
    if !(within > limits.divisor) {
        return None;
    }
    let c = f.dot(f) - r_square;
    if !(c.abs() > limits.dividend) {
        return None;
    }
    // The signs of c and h are sure: with c > 0, a root needs h² > a c.
    let (is_ahead, is_inside) = (h < 0.0, c < 0.0);
    if !is_ahead && !is_inside {
        // Both roots are negative, and so before any `min_t` that a window knows.
        return window.after.is_finite().then_some(None);
    }
    let q = h.abs() + (a * within).sqrt();
    // From inside, the near root is negative; from outside, it may be before `min_t`.
    let t = match is_ahead {
        true if !is_inside && c / q >= window.before => c / q,
        true => q / a,
        false => -(c / q),
    };
    window.answer(t, scaled)
}

/// The answer by exact signs.
#[cold]
#[inline(never)]
pub fn exact(sphere: &Sphere<f64>, ray: &Ray<f64>, min_t: f64) -> Option<Root> {
    let finite = |vector: Vector<f64>| vector.array().into_iter().all(f64::is_finite);
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
