//! Numbers of twice the digits: an unevaluated sum of two of the machine's own (Dekker,
//! *Numer. Math.* 18, 1971). About 106 bits in `f64`, with `f64`'s range.

use std::ops::{Add, Div, Mul, Neg, Sub};

use crate::number::Real;
use crate::vector::Vector;

/// `high` + `low`, with |`low`| at most half an ulp of `high`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DoubleDouble<F> {
    /// The sum, rounded.
    pub high: F,
    /// What the rounding lost.
    pub low: F,
}

impl<F: Real> DoubleDouble<F> {
    /// The sum of two numbers without loss (Knuth's TwoSum, *TAOCP* vol. 2, §4.2.2).
    #[inline(always)]
    pub fn sum(a: F, b: F) -> DoubleDouble<F> {
        let high = a + b;
        let of_b = high - a;
        let low = (a - (high - of_b)) + (b - of_b);
        DoubleDouble { high, low }
    }

    /// The product of two numbers without loss, unless it underflows (Ogita, Rump &
    /// Oishi, *SIAM J. Sci. Comput.* 26, 2005, algorithm 3.5: TwoProductFMA).
    #[inline(always)]
    pub fn product(a: F, b: F) -> DoubleDouble<F> {
        let high = a * b;
        let low = a.mul_add(b, -high);
        DoubleDouble { high, low }
    }

    /// `high` + `low` anew, where |`high`| ≥ |`low`| (Dekker's FastTwoSum).
    #[inline(always)]
    fn renewed(high: F, low: F) -> DoubleDouble<F> {
        let sum = high + low;
        DoubleDouble {
            high: sum,
            low: low - (sum - high),
        }
    }

    /// The square root: one step of Newton's from the rounded one (Karp & Markstein,
    /// *ACM TOMS* 23, 1997).
    #[inline(always)]
    pub fn sqrt(self) -> DoubleDouble<F> {
        if self.high <= F::ZERO {
            return DoubleDouble {
                high: self.high.sqrt(),
                low: F::ZERO,
            };
        }
        let root = self.high.sqrt();
        let rest = self - DoubleDouble::product(root, root);
        DoubleDouble::renewed(root, rest.high / (root + root))
    }
}

impl<F: Real> From<F> for DoubleDouble<F> {
    #[inline(always)]
    fn from(high: F) -> Self {
        DoubleDouble { high, low: F::ZERO }
    }
}

impl<F: Real> Add for DoubleDouble<F> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        let high = DoubleDouble::sum(self.high, other.high);
        let low = DoubleDouble::sum(self.low, other.low);
        let first = DoubleDouble::renewed(high.high, high.low + low.high);
        DoubleDouble::renewed(first.high, first.low + low.low)
    }
}

impl<F: Real> Neg for DoubleDouble<F> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        DoubleDouble {
            high: -self.high,
            low: -self.low,
        }
    }
}

impl<F: Real> Sub for DoubleDouble<F> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl<F: Real> Mul for DoubleDouble<F> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        let product = DoubleDouble::product(self.high, other.high);
        let cross = self.high * other.low + self.low * other.high;
        DoubleDouble::renewed(product.high, product.low + cross)
    }
}

impl<F: Real> Div for DoubleDouble<F> {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        let first = self.high / other.high;
        let rest = self - other * first.into();
        DoubleDouble::renewed(first, rest.high / other.high)
    }
}

/// A vector of such numbers: the difference of two points without loss, and products.
#[derive(Clone, Copy, Debug)]
pub struct DoubleVector<F>([DoubleDouble<F>; 3]);

impl<F: Real> DoubleVector<F> {
    /// `a` − `b`, without loss.
    #[inline(always)]
    pub fn between(a: Vector<F>, b: Vector<F>) -> DoubleVector<F> {
        let less = |a: F, b: F| DoubleDouble::sum(a, -b);
        DoubleVector([less(a.x, b.x), less(a.y, b.y), less(a.z, b.z)])
    }

    /// The same vector.
    #[inline(always)]
    pub fn of(vector: Vector<F>) -> DoubleVector<F> {
        DoubleVector(vector.array().map(DoubleDouble::from))
    }

    /// The largest component's magnitude, rounded.
    #[inline(always)]
    pub fn largest(self) -> F {
        let [x, y, z] = self.0.map(|component| component.high.abs());
        x.max(y).max(z)
    }

    /// The dot product.
    #[inline(always)]
    pub fn dot(self, other: DoubleVector<F>) -> DoubleDouble<F> {
        let ([a, b, c], [x, y, z]) = (self.0, other.0);
        a * x + b * y + c * z
    }

    /// The cross product.
    #[inline(always)]
    pub fn cross(self, other: DoubleVector<F>) -> DoubleVector<F> {
        let ([a, b, c], [x, y, z]) = (self.0, other.0);
        DoubleVector([b * z - c * y, c * x - a * z, a * y - b * x])
    }
}
