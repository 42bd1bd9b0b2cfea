//! The leading 106 bits of an exact number, with an exponent that never overflows: what
//! an exact kernel divides and takes roots of when its decision is made.

use std::ops::{Add, Div, Mul, Neg};

use crate::double_double::DoubleDouble;
use crate::dyadic::Dyadic;
use crate::number::{Real, exponent};

/// `value` × 2^`exponent`, good to about 2⁻¹⁰⁴ of itself.
#[derive(Clone, Copy, Debug)]
pub struct Leading {
    value: DoubleDouble,
    exponent: i64,
}

impl Leading {
    /// The square root of what is not negative.
    pub fn sqrt(self) -> Leading {
        let odd = self.exponent.rem_euclid(2);
        Leading {
            value: scaled(self.value, odd).sqrt(),
            exponent: (self.exponent - odd) / 2,
        }
    }

    /// The e of 2^e ≤ |value| < 2^(e + 1); none of 0.
    pub fn exponent(self) -> Option<i64> {
        (self.value.high != 0.0).then_some(self.exponent)
    }

    /// self × 2^`power`.
    pub fn times_power_of_two(self, power: i64) -> Leading {
        let exponent = self.exponent + power;
        Leading { exponent, ..self }
    }

    /// Rounded to a float; infinite if that is too small for it.
    pub fn rounded(self) -> f64 {
        let power = self.exponent.clamp(-3000, 3000) as i32;
        self.value.high.times_power_of_two(power)
    }
}

fn scaled(value: DoubleDouble, power: i64) -> DoubleDouble {
    let power = power.clamp(-3000, 3000) as i32;
    DoubleDouble {
        high: value.high.times_power_of_two(power),
        low: value.low.times_power_of_two(power),
    }
}

impl From<&Dyadic> for Leading {
    fn from(number: &Dyadic) -> Leading {
        let (value, exponent) = number.leading();
        Leading { value, exponent }
    }
}

impl Neg for Leading {
    type Output = Leading;
    fn neg(self) -> Leading {
        Leading {
            value: -self.value,
            ..self
        }
    }
}

impl Add for Leading {
    type Output = Leading;
    fn add(self, other: Leading) -> Leading {
        let (large, small) = match self.exponent >= other.exponent {
            _ if self.value.high == 0.0 => return other,
            _ if other.value.high == 0.0 => return self,
            true => (self, other),
            false => (other, self),
        };
        let sum = large.value + scaled(small.value, small.exponent - large.exponent);
        let shift = i64::from(exponent(sum.high));
        Leading {
            value: scaled(sum, -shift),
            exponent: large.exponent + shift,
        }
    }
}

impl Mul for Leading {
    type Output = Leading;
    fn mul(self, other: Leading) -> Leading {
        Leading {
            value: self.value * other.value,
            exponent: self.exponent + other.exponent,
        }
    }
}

impl Div for Leading {
    type Output = Leading;
    fn div(self, other: Leading) -> Leading {
        Leading {
            value: self.value / other.value,
            exponent: self.exponent - other.exponent,
        }
    }
}
