//! Exact answers, before anything is rounded: what tells which of two shapes comes first
//! where their t agree in every digit of a float.

use std::cmp::Ordering;

use crate::dyadic::{Dyadic, DyadicVector};

/// (`rational` ± √`radicand`) / `divisor`: a root of a linear or a quadratic equation.
#[derive(Clone, Debug)]
pub struct Root {
    rational: Dyadic,
    /// −1 or 1.
    sign: i32,
    /// Not negative.
    radicand: Dyadic,
    /// Positive.
    divisor: Dyadic,
}

impl Root {
    /// A fraction; its divisor is not 0.
    pub fn fraction(numerator: Dyadic, divisor: Dyadic) -> Root {
        debug_assert!(divisor.sign() != 0, "nothing is divided by 0");
        let is_negative = divisor.sign() < 0;
        let upright = |x: Dyadic| if is_negative { -x } else { x };
        Root {
            rational: upright(numerator),
            sign: 1,
            radicand: Dyadic::of(0.0),
            divisor: upright(divisor),
        }
    }

    /// (`rational` + `sign` √`radicand`) / `divisor`, where the last two are not negative.
    pub fn quadratic(rational: Dyadic, sign: i32, radicand: Dyadic, divisor: Dyadic) -> Root {
        debug_assert!(radicand.sign() >= 0 && divisor.sign() > 0 && sign.abs() == 1);
        Root {
            rational,
            sign,
            radicand,
            divisor,
        }
    }

    /// The nearest float, from more than a hundred bits: where the two terms would cancel,
    /// p + s = (p² − s²) / (p − s).
    pub fn rounded(&self) -> f64 {
        let root = self.root();
        let cancels = self.rational.sign() * root.sign() < 0;
        let numerator = match cancels {
            false => &self.rational + &root,
            true => {
                let squares = &(&self.rational * &self.rational) - &self.radicand;
                squares.over(&(&self.rational - &root))
            }
        };
        numerator.over(&self.divisor).rounded()
    }

    /// ±√`radicand`, to 2⁻¹²⁸ of itself.
    fn root(&self) -> Dyadic {
        let root = self.radicand.sqrt();
        if self.sign < 0 { -root } else { root }
    }

    /// Along e + t d, if this is t: times the divisor, and good to a hundred bits of its length,
    /// as long as the two terms of t leave it no longer than either. On a sphere they do, for
    /// from the centre e less its part along d and the rest are at right angles.
    pub fn point(&self, e: &DyadicVector, d: &DyadicVector) -> DyadicVector {
        let t = &self.rational + &self.root();
        DyadicVector([0, 1, 2].map(|axis| &(&self.divisor * &e.0[axis]) + &(&t * &d.0[axis])))
    }

    /// Which is smaller, whatever their digits.
    pub fn compare(&self, other: &Root) -> Ordering {
        // The difference times both divisors is a + b √self.radicand + c √other.radicand.
        let a = &(&self.rational * &other.divisor) - &(&other.rational * &self.divisor);
        let signed = |sign: i32, factor: &Dyadic| match sign < 0 {
            true => -factor.clone(),
            false => factor.clone(),
        };
        let b = signed(self.sign, &other.divisor);
        let c = signed(-other.sign, &self.divisor);
        let first = sign_of(&a, &b, &self.radicand);
        let second = c.sign() * other.radicand.sign();
        let sign = match first * second {
            0.. => first + second,
            _ => {
                let of_a = &(&a * &a) + &(&(&b * &b) * &self.radicand);
                let squares = &of_a - &(&(&c * &c) * &other.radicand);
                let twice = &Dyadic::of(2.0) * &(&a * &b);
                first * sign_of(&squares, &twice, &self.radicand)
            }
        };
        sign.cmp(&0)
    }
}

/// An exact answer as a kernel gives it: the nearest finite number. What is met further away
/// than numbers reach is met.
pub fn rounded(root: Option<Root>) -> Option<f64> {
    Some(root?.rounded().clamp(f64::MIN, f64::MAX))
}

/// The sign of a + b √`radicand`: where the terms have opposite signs, the larger square
/// decides.
fn sign_of(a: &Dyadic, b: &Dyadic, radicand: &Dyadic) -> i32 {
    let (first, second) = (a.sign(), b.sign() * radicand.sign());
    match first * second {
        0.. => (first + second).signum(),
        _ => first * (&(a * a) - &(&(b * b) * radicand)).sign(),
    }
}
