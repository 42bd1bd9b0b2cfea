//! Exact roots, before anything is rounded. They tell which of two hits comes first even if
//! their t agree in every digit of a float.

use std::cmp::Ordering;

use crate::dyadic::Dyadic;
use crate::vector::Vector;

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
    /// A fraction. `divisor` must not be 0.
    pub fn fraction(numerator: Dyadic, divisor: Dyadic) -> Root {
        debug_assert!(divisor.sign() != 0, "the divisor is not 0");
        let is_negative = divisor.sign() < 0;
        let upright = |x: Dyadic| if is_negative { -x } else { x };
        Root {
            rational: upright(numerator),
            sign: 1,
            radicand: Dyadic::of(0.0),
            divisor: upright(divisor),
        }
    }

    /// (`rational` + `sign` √`radicand`) / `divisor`, with a radicand that is not negative and
    /// a positive divisor.
    pub fn quadratic(rational: Dyadic, sign: i32, radicand: Dyadic, divisor: Dyadic) -> Root {
        debug_assert!(radicand.sign() >= 0 && divisor.sign() > 0 && sign.abs() == 1);
        Root {
            rational,
            sign,
            radicand,
            divisor,
        }
    }

    /// The nearest float, rounded from more than a hundred bits. Where p + s would cancel, it
    /// is computed as (p² − s²) / (p − s).
    pub fn rounded(&self) -> f64 {
        if self.radicand.sign() == 0 {
            return self.rational.rounded_over(&self.divisor);
        }
        let (rational, root) = (self.rational.clone(), self.root());
        let cancels = rational.sign() * root.sign() < 0;
        let numerator = match cancels {
            false => rational + root,
            true => {
                let squares = rational.clone().squared() - self.radicand.clone();
                squares.over(&(rational - root))
            }
        };
        numerator.rounded_over(&self.divisor)
    }

    /// ±√`radicand`, with a relative error below 2⁻¹²⁷.
    fn root(&self) -> Dyadic {
        let root = self.radicand.sqrt();
        if self.sign < 0 { -root } else { root }
    }

    /// The vector e + t d, where t is this root, times the divisor. It has a hundred correct
    /// bits relative to its length if the sum of e + (`rational`/`divisor`) d and
    /// ±(√`radicand`/`divisor`) d is no shorter than either. On a sphere, with e relative to
    /// the centre, these two are perpendicular, so this holds.
    pub fn point(&self, e: Vector<Dyadic>, d: Vector<Dyadic>) -> Vector<Dyadic> {
        e * self.divisor.clone() + d * (self.rational.clone() + self.root())
    }

    /// Compares two roots exactly.
    pub fn compare(&self, other: &Root) -> Ordering {
        // The difference times both divisors is a + b √self.radicand + c √other.radicand.
        let times = |p: &Dyadic, q: &Dyadic| p.clone() * q.clone();
        let a = times(&self.rational, &other.divisor) - times(&other.rational, &self.divisor);
        if self.radicand.sign() == 0 && other.radicand.sign() == 0 {
            return a.sign().cmp(&0);
        }
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
                let of_a = a.clone().squared() + times(&b.clone().squared(), &self.radicand);
                let squares = of_a - times(&c.squared(), &other.radicand);
                let twice = Dyadic::of(2.0) * a * b;
                first * sign_of(&squares, &twice, &self.radicand)
            }
        };
        sign.cmp(&0)
    }
}

/// An exact answer as a kernel returns it: the nearest finite float. A hit beyond the largest
/// float is clamped to it.
pub fn rounded(root: Option<Root>) -> Option<f64> {
    Some(root?.rounded().clamp(f64::MIN, f64::MAX))
}

/// The sign of a + b √`radicand`. If the terms have opposite signs, the one with the larger
/// square decides.
fn sign_of(a: &Dyadic, b: &Dyadic, radicand: &Dyadic) -> i32 {
    let (first, second) = (a.sign(), b.sign() * radicand.sign());
    match first * second {
        0.. => (first + second).signum(),
        _ => {
            let squares = a.clone().squared() - b.clone().squared() * radicand.clone();
            first * squares.sign()
        }
    }
}
