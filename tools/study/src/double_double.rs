//! Double-double arithmetic: a number is the unevaluated sum of two floats (Dekker, *Numer.
//! Math.* 18, 1971). It has about 106 bits, with the range of `f64`.

use std::ops::{Add, Mul, Neg, Sub};

use crate::vector::Vector;

/// `high` + `low`, with |`low`| at most half an ulp of `high`.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct DoubleDouble {
    /// The sum, rounded.
    pub high: f64,
    /// The rounding error of `high`.
    pub low: f64,
}

impl DoubleDouble {
    /// The exact sum of two numbers (Knuth's TwoSum, *TAOCP* vol. 2, §4.2.2).
    pub fn sum(a: f64, b: f64) -> DoubleDouble {
        let high = a + b;
        let of_b = high - a;
        let low = (a - (high - of_b)) + (b - of_b);
        DoubleDouble { high, low }
    }

    /// The exact product of two numbers, unless it underflows (Ogita, Rump & Oishi, *SIAM J.
    /// Sci. Comput.* 26, 2005, algorithm 3.5: TwoProductFMA).
    pub fn product(a: f64, b: f64) -> DoubleDouble {
        let high = a * b;
        let low = a.mul_add(b, -high);
        DoubleDouble { high, low }
    }

    /// The quotient: one step of long division after the first.
    pub fn over(self, other: DoubleDouble) -> DoubleDouble {
        let high = self.high / other.high;
        let rest = self - other * DoubleDouble::from(high);
        DoubleDouble::renewed(high, rest.high / other.high)
    }

    /// The square root of a positive number: one step of Newton's method after the first.
    pub fn sqrt(self) -> DoubleDouble {
        let high = self.high.sqrt();
        let rest = self - DoubleDouble::product(high, high);
        DoubleDouble::renewed(high, rest.high / (2.0 * high))
    }

    /// Renormalises `high` + `low`, where |`high`| ≥ |`low`| (Dekker's FastTwoSum).
    fn renewed(high: f64, low: f64) -> DoubleDouble {
        let sum = high + low;
        DoubleDouble {
            high: sum,
            low: low - (sum - high),
        }
    }
}

impl From<f64> for DoubleDouble {
    fn from(high: f64) -> Self {
        DoubleDouble { high, low: 0.0 }
    }
}

impl Add for DoubleDouble {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let high = DoubleDouble::sum(self.high, other.high);
        let low = DoubleDouble::sum(self.low, other.low);
        let first = DoubleDouble::renewed(high.high, high.low + low.high);
        DoubleDouble::renewed(first.high, first.low + low.low)
    }
}

impl Neg for DoubleDouble {
    type Output = Self;
    fn neg(self) -> Self {
        DoubleDouble {
            high: -self.high,
            low: -self.low,
        }
    }
}

impl Sub for DoubleDouble {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for DoubleDouble {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let product = DoubleDouble::product(self.high, other.high);
        let cross = self.high * other.low + self.low * other.high;
        DoubleDouble::renewed(product.high, product.low + cross)
    }
}

impl Vector<DoubleDouble> {
    /// `a` − `b`, exactly.
    pub fn between(a: Vector<f64>, b: Vector<f64>) -> Vector<DoubleDouble> {
        a.zip(b, |a, b| DoubleDouble::sum(a, -b))
    }

    /// The nearest vector of floats.
    pub fn rounded(self) -> Vector<f64> {
        self.map(|component| component.high)
    }
}
