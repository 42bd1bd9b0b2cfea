use dashu_int::UBig;
use dashu_int::ops::{BitTest, SquareRoot};
use dashu_ratio::Relaxed;

use super::{Exact, HasTruth, Root, Truth, fraction, sign};
use crate::question::Question;
use crate::shape::Sphere;

/// Bits of a computed square root. The roots of the quadratic are formed without cancellation, so
/// they keep all but a few of these.
pub const BITS: usize = 340;

impl HasTruth for Sphere<f64> {
    /// a t² + 2 h t + c = 0 has the roots (−h ∓ √Δ) / a. With m = `min_t` and k = −h − a m, the
    /// near root is ≥ m if k ≥ √Δ, and the far root is ≥ m if −k ≤ √Δ. Both follow from the
    /// signs of k and k² − Δ.
    fn truth(question: &Question<Self>) -> Truth {
        let Question { shape, ray, min_t } = question;
        let d = Exact::of(ray.direction);
        let f = Exact::of(ray.origin).minus(&Exact::of(shape.center));
        let radius = fraction(shape.radius);
        let (a, h, c) = (d.dot(&d), d.dot(&f), f.dot(&f) - &radius * &radius);
        let discriminant = &h * &h - &a * &c;
        if sign(&a) == 0 || sign(&discriminant) < 0 {
            return Truth::miss(false);
        }
        let k = -(&h + &a * fraction(*min_t));
        let (k_sign, beyond) = (sign(&k), sign(&(&k * &k - &discriminant)));
        let is_near = k_sign >= 0 && beyond >= 0;
        let is_far = k_sign >= 0 || beyond <= 0;
        let is_tie = sign(&discriminant) == 0 || beyond == 0;
        if !is_near && !is_far {
            return Truth::miss(is_tie);
        }
        let root = square_root(&discriminant);
        let (near, far) = match sign(&h) < 0 {
            true => (&c / (&root - &h), (&root - &h) / &a),
            false if sign(&root) == 0 && sign(&h) == 0 => (fraction(0.0), fraction(0.0)),
            false => (-(&h + &root) / &a, -(&c / (&h + &root))),
        };
        let (t, other) = if is_near { (near, far) } else { (far, near) };
        Truth {
            t: Some(Root::from(t)),
            other: Some(Root::from(other)),
            is_tie,
        }
    }
}

/// The square root of n/d, as √(n d) / d, rounded down to [`BITS`] bits or more.
fn square_root(value: &Relaxed) -> Relaxed {
    let product = value.numerator() * dashu_int::IBig::from(value.denominator().clone());
    let product = UBig::try_from(product).expect("the discriminant is not negative");
    let shift = (2 * BITS).saturating_sub(product.bit_len()).div_ceil(2);
    let root = (product << (2 * shift)).sqrt();
    Relaxed::from_parts(root.into(), value.denominator().clone() << shift)
}
