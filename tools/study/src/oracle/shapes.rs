//! The true answer for each shape.

use dashu_int::UBig;
use dashu_int::ops::{BitTest, SquareRoot};
use dashu_ratio::Relaxed;

use super::{Exact, HasTruth, Root, Truth, fraction, sign};
use crate::question::Question;
use crate::shape::{Plane, Sphere, Triangle};

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
        let (t, other) = (Root::from(t), Root::from(other));
        let length = ray.direction.array().into_iter().fold(0.0, f64::hypot);
        Truth {
            are_apart: (other.value - t.value).abs() > shape.radius.abs() / length,
            t: Some(t),
            other: Some(other),
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

impl HasTruth for Plane<f64> {
    /// t = n·(p − e) / n·d; a miss if n·d is exactly 0.
    fn truth(question: &Question<Self>) -> Truth {
        let Question { shape, ray, min_t } = question;
        let normal = Exact::of(shape.normal);
        let along = normal.dot(&Exact::of(ray.direction));
        let height = normal.dot(&Exact::of(shape.point).minus(&Exact::of(ray.origin)));
        if sign(&along) == 0 {
            return Truth::miss(sign(&height) == 0);
        }
        Truth::only(height / along, *min_t, false)
    }
}

impl HasTruth for Triangle<f64> {
    /// Solves e − a = α t₁ + β t₂ − t d by Cramer's rule, in fractions. Edges belong to the
    /// triangle, and a ray that touches one is a tie.
    fn truth(question: &Question<Self>) -> Truth {
        let Question { shape, ray, min_t } = question;
        let [a, b, c] = shape.corners.map(Exact::of);
        let (t1, t2, d) = (b.minus(&a), c.minus(&a), Exact::of(ray.direction));
        let from_a = Exact::of(ray.origin).minus(&a);
        // The determinant |t₁ t₂ −d| is −d·(t₁ × t₂); the others replace one column by e − a.
        let normal = t1.cross(&t2);
        let determinant = -d.dot(&normal);
        if sign(&determinant) == 0 {
            return Truth::miss(false);
        }
        let alpha = d.dot(&t2.cross(&from_a)) / &determinant;
        let beta = d.dot(&from_a.cross(&t1)) / &determinant;
        let rest = fraction(1.0) - &alpha - &beta;
        let signs = [sign(&alpha), sign(&beta), sign(&rest)];
        if signs.contains(&-1) {
            return Truth::miss(false);
        }
        let t = from_a.dot(&normal) / &determinant;
        Truth::only(t, *min_t, signs.contains(&0))
    }
}
