use super::haines::Scaled;
use crate::kernel::{Limits, Window};
use crate::number::Real;
use crate::shape::Sphere;

/// For rays whose origin is up to `away` from the centre, in each component: |f| is at
/// most 1.74 of that. What has a sign is r² − |l|²: below −`sign` it is a
/// miss, above `divisor` a hit whose roots are good to √u.
///
/// With E = 16 (√u (|l|² + r²) + u√u |f|²), the bound of r² − |l|² in [`super::Adaptive`]:
///
/// 1. If |l|² ≤ 2r², E ≤ 48√u r² + 16u√u |f|², and `sign` is more. If |l|² > 2r², then
///    r² − |l|² < −|l|²/2, and E ≤ 24√u |l|² + `sign`/2, of which the first is below a
///    half of |l|²/2 in either type. So what is below −`sign` is below −E.
/// 2. A hit's q is good if 24u a |f| (r + 6u|f|) + 28u |f| root < √u q root. As q ≥
///    root, 48√u |f| (r + 6u|f|) and 3136u |f|² below root²/a = r² − |l|² suffice
///    (a ≥ 1, for the ray is scaled).
/// 3. c = |f|² − r² is the dividend.
pub fn limits<F: Real>(sphere: &Sphere<F>, away: F) -> Limits<F> {
    let (u, root_u, r) = (F::UNIT_ROUNDOFF, F::ROOT_OF_UNIT, sphere.radius.abs());
    let size = F::of(1.74) * away;
    let (size_square, r_square) = (size * size, r * r);
    let underflow = F::of(128.0) * F::TINY;
    let sign =
        F::of(64.0) * root_u * r_square + F::of(32.0) * root_u * (u * size_square) + underflow;
    let divisor = F::of(64.0) * root_u * size * (r + F::of(6.0) * u * size)
        + F::of(4096.0) * u * size_square
        + sign;
    let dividend = F::of(16.0) * root_u * (size_square + r_square) + underflow;
    Limits {
        sign,
        divisor,
        dividend,
    }
}

/// The answer of [`super::filtered`], or, more often than there, `None`.
#[inline(always)]
pub fn bounded<F: Real>(
    sphere: &Sphere<F>,
    scaled: &Scaled<F>,
    window: &Window<F>,
    limits: &Limits<F>,
) -> Option<Option<F>> {
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
    let (is_ahead, is_inside) = (h < F::ZERO, c < F::ZERO);
    if !is_ahead && !is_inside {
        // Both roots are negative, and so before any `min_t` that a window knows.
        return window.after.is_finite().then_some(None);
    }
    let q = h.abs() + (a * within).sqrt();
    let t = match (is_ahead, is_inside) {
        (true, false) => c / q,
        // From inside, the near root is negative.
        (true, true) => q / a,
        _ => -(c / q),
    };
    if is_inside && t < window.before {
        return Some(None);
    }
    let t = (t > window.after).then(|| scaled.unscale(t))?;
    t.is_finite().then_some(Some(t))
}
