//! Dyadic rationals: integers times powers of two. Every finite float is one, and so is every
//! sum and product of floats, without rounding, overflow or underflow. The adaptive kernels use
//! them to decide what their filters cannot.
//!
//! The integers are num-bigint's. The oracle uses dashu's rationals instead, so the two share
//! no code. Expansions (Shewchuk, *Discrete Comput. Geom.* 18, 1997) would be faster, but they
//! are exact only while no partial product underflows, and this package studies extreme
//! numbers.

use std::ops::{Add, Mul, Neg, Sub};

use num_bigint::{BigInt, Sign};

use crate::number::Real;
use crate::vector::Vector;

/// `integer` × 2^`exponent`.
#[derive(Clone, Debug)]
pub struct Dyadic {
    integer: BigInt,
    exponent: i64,
}

/// Quotients and roots have at least this many bits.
const BITS: i64 = 128;

impl Dyadic {
    /// A finite number, exactly.
    pub fn of(value: f64) -> Dyadic {
        let bits = value.to_bits();
        let (field, fraction) = ((bits >> 52) & 0x7ff, (bits & ((1 << 52) - 1)) as i64);
        debug_assert!(field < 0x7ff, "only finite numbers are dyadic");
        let (mantissa, exponent) = match field {
            0 => (fraction, -1074),
            _ => (fraction | (1 << 52), field as i64 - 1075),
        };
        let integer = BigInt::from(if bits >> 63 == 1 { -mantissa } else { mantissa });
        Dyadic { integer, exponent }
    }

    /// −1, 0 or 1.
    pub fn sign(&self) -> i32 {
        match self.integer.sign() {
            Sign::Minus => -1,
            Sign::NoSign => 0,
            Sign::Plus => 1,
        }
    }

    /// The e with 2^e ≤ |self| < 2^(e + 1); `None` for 0.
    pub fn magnitude(&self) -> Option<i64> {
        let bits = self.integer.bits() as i64;
        (bits > 0).then_some(self.exponent + bits - 1)
    }

    /// self × self.
    pub fn squared(self) -> Dyadic {
        self.clone() * self
    }

    /// self × 2^`power`.
    pub fn times_power_of_two(mut self, power: i64) -> Dyadic {
        self.exponent += power;
        self
    }

    /// The square root of a non-negative number, rounded down, with a relative error below
    /// 2⁻¹²⁸.
    pub fn sqrt(&self) -> Dyadic {
        let up = 2 * BITS - self.integer.bits() as i64;
        // Makes the remaining exponent even.
        let up = up + (self.exponent - up).rem_euclid(2);
        let scaled = match up < 0 {
            true => &self.integer >> -up,
            false => &self.integer << up,
        };
        Dyadic {
            integer: scaled.sqrt(),
            exponent: (self.exponent - up) / 2,
        }
    }

    /// self / `divisor`, which is not 0, rounded towards 0 with a relative error below 2⁻¹²⁸.
    pub fn over(&self, divisor: &Dyadic) -> Dyadic {
        let bits = |number: &Dyadic| number.integer.bits() as i64;
        let up = (BITS + 1 + bits(divisor) - bits(self)).max(0);
        Dyadic {
            integer: (&self.integer << up) / &divisor.integer,
            exponent: self.exponent - up - divisor.exponent,
        }
    }

    /// The nearest float; infinite if the number is too large. A subnormal result may be the
    /// second nearest float, because it is rounded twice.
    pub fn rounded(&self) -> f64 {
        let bits = self.integer.bits() as i64;
        // The top 63 bits, with the last bit set if any lower bit is (a sticky bit), so that
        // ties are rounded correctly.
        let down = (bits - 63).max(0);
        let top = &self.integer >> down;
        let zeros = self.integer.trailing_zeros().unwrap_or(0) as i64;
        let top = i64::try_from(&top).expect("it has 63 bits") | i64::from(zeros < down);
        let power = (self.exponent + down).clamp(-3000, 3000) as i32;
        (top as f64).times_power_of_two(power)
    }

    /// The integers of two numbers, brought to the smaller of their exponents.
    fn aligned(self, other: Dyadic) -> (BigInt, BigInt, i64) {
        let exponent = self.exponent.min(other.exponent);
        let at = |number: Dyadic| number.integer << (number.exponent - exponent);
        (at(self), at(other), exponent)
    }
}

impl Add for Dyadic {
    type Output = Dyadic;
    fn add(self, other: Dyadic) -> Dyadic {
        let (a, b, exponent) = self.aligned(other);
        let integer = a + b;
        Dyadic { integer, exponent }
    }
}

impl Sub for Dyadic {
    type Output = Dyadic;
    fn sub(self, other: Dyadic) -> Dyadic {
        self + -other
    }
}

impl Neg for Dyadic {
    type Output = Dyadic;
    fn neg(self) -> Dyadic {
        let (integer, exponent) = (-self.integer, self.exponent);
        Dyadic { integer, exponent }
    }
}

impl Mul for Dyadic {
    type Output = Dyadic;
    fn mul(self, other: Dyadic) -> Dyadic {
        Dyadic {
            integer: self.integer * other.integer,
            exponent: self.exponent + other.exponent,
        }
    }
}

impl Vector<Dyadic> {
    /// The unit vector along it. All components are first scaled by the same power of two, so
    /// that none overflows. A component that vanishes beside the largest becomes 0.
    pub fn rounded_unit(self) -> Vector<f64> {
        let components = self.array();
        let largest = components.iter().filter_map(Dyadic::magnitude).max();
        let down = -largest.unwrap_or(0);
        let [x, y, z] = components.map(|it| it.times_power_of_two(down).rounded());
        Vector::new(x, y, z).unit()
    }
}
