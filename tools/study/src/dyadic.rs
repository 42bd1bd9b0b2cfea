//! Dyadic rationals: integers times powers of two. Every finite float is one, and so is every
//! sum and product of floats, without rounding, overflow or underflow. The adaptive kernels use
//! them to decide what their filters cannot.
//!
//! Long integers are num-bigint's. The oracle uses dashu's rationals instead, so the two share
//! no code. Expansions (Shewchuk, *Discrete Comput. Geom.* 18, 1997) would be faster, but they
//! are exact only while no partial product underflows, and this package studies extreme
//! numbers. Numbers with few bits do not need them: see [`short`](crate::kernel::short).

use std::ops::{Add, Mul, Neg, Sub};

use num_bigint::BigInt;
use num_traits::{Float, Signed};

use crate::number::Real;
use crate::vector::Vector;

/// `integer` × 2^`exponent`.
#[derive(Clone, Debug)]
pub struct Dyadic {
    integer: Integer,
    exponent: i64,
}

/// Where many rays hit edges exactly, coordinates tend to have few digits. Products of three or
/// four of them then fit into 128 bits, which need no memory from the heap.
#[derive(Clone, Debug)]
enum Integer {
    Short(i128),
    Long(BigInt),
}

impl Integer {
    fn long(self) -> BigInt {
        match self {
            Integer::Short(value) => value.into(),
            Integer::Long(value) => value,
        }
    }
}

/// Quotients and roots have at least this many bits.
const BITS: i64 = 128;

impl Dyadic {
    /// A finite number, exactly.
    pub fn of(value: f64) -> Dyadic {
        debug_assert!(value.is_finite(), "only finite numbers are dyadic");
        let (mantissa, exponent, sign) = value.integer_decode();
        let zeros = mantissa.trailing_zeros() % 64;
        let odd = i128::from(mantissa >> zeros);
        Dyadic {
            integer: Integer::Short(if sign < 0 { -odd } else { odd }),
            exponent: i64::from(exponent) + i64::from(zeros),
        }
    }

    /// −1, 0 or 1.
    pub fn sign(&self) -> i32 {
        match &self.integer {
            Integer::Short(value) => value.signum() as i32,
            Integer::Long(value) => i32::from(value.is_positive()) - i32::from(value.is_negative()),
        }
    }

    /// The e with 2^e ≤ |self| < 2^(e + 1); `None` for 0.
    pub fn magnitude(&self) -> Option<i64> {
        let bits = self.bits();
        (bits > 0).then_some(self.exponent + bits - 1)
    }

    /// The number of bits of the integer.
    fn bits(&self) -> i64 {
        match &self.integer {
            Integer::Short(value) => i64::from(128 - value.unsigned_abs().leading_zeros()),
            Integer::Long(value) => value.bits() as i64,
        }
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
    /// 2⁻¹²⁷.
    pub fn sqrt(&self) -> Dyadic {
        let up = 2 * BITS - self.bits();
        // Makes the remaining exponent even.
        let up = up + (self.exponent - up).rem_euclid(2);
        let integer = self.integer.clone().long();
        let scaled = match up < 0 {
            true => integer >> -up,
            false => integer << up,
        };
        Dyadic {
            integer: Integer::Long(scaled.sqrt()),
            exponent: (self.exponent - up) / 2,
        }
    }

    /// self / `divisor`, which is not 0, rounded towards 0 with a relative error below 2⁻¹²⁸.
    pub fn over(&self, divisor: &Dyadic) -> Dyadic {
        let up = (BITS + 1 + divisor.bits() - self.bits()).max(0);
        let [dividend, divided] = [self, divisor].map(|it| it.integer.clone().long());
        Dyadic {
            integer: Integer::Long((dividend << up) / divided),
            exponent: self.exponent - up - divisor.exponent,
        }
    }

    /// self / `divisor`, rounded. If both have few digits, the division of floats is as good as that
    /// of integers, and takes a small part of the instructions.
    pub fn rounded_over(&self, divisor: &Dyadic) -> f64 {
        if let (Integer::Short(p), Integer::Short(q)) = (&self.integer, &divisor.integer)
            && self.bits().max(divisor.bits()) <= i64::from(f64::MANTISSA_DIGITS)
        {
            let power = (self.exponent - divisor.exponent).clamp(-3000, 3000);
            let quotient = (*p as f64 / *q as f64).times_power_of_two(power as i32);
            if quotient.is_normal() {
                return quotient;
            }
        }
        self.over(divisor).rounded()
    }

    /// The nearest float; infinite if the number is too large. A subnormal result may be the
    /// second nearest float, because it is rounded twice.
    pub fn rounded(&self) -> f64 {
        // The top 63 bits, with the last bit set if any lower bit is (a sticky bit), so that
        // ties are rounded correctly.
        let down = (self.bits() - 63).max(0);
        let integer = self.integer.clone().long();
        let top = &integer >> down;
        let zeros = integer.trailing_zeros().unwrap_or(0) as i64;
        let top = i64::try_from(&top).expect("it has 63 bits") | i64::from(zeros < down);
        let power = (self.exponent + down).clamp(-3000, 3000) as i32;
        (top as f64).times_power_of_two(power)
    }
}

impl Add for Dyadic {
    type Output = Dyadic;
    #[inline]
    fn add(self, other: Dyadic) -> Dyadic {
        let (low, high) = match self.exponent <= other.exponent {
            true => (self, other),
            false => (other, self),
        };
        let up = high.exponent - low.exponent;
        match (&low.integer, &high.integer) {
            // The exponent of a zero means nothing.
            (_, Integer::Short(0)) => return low,
            (Integer::Short(0), _) => return high,
            (&Integer::Short(a), &Integer::Short(b))
                if up < i64::from(b.unsigned_abs().leading_zeros()) =>
            {
                if let Some(sum) = a.checked_add(b << up) {
                    return Dyadic {
                        integer: Integer::Short(sum),
                        exponent: low.exponent,
                    };
                }
            }
            _ => {}
        }
        Dyadic {
            integer: Integer::Long(low.integer.long() + (high.integer.long() << up)),
            exponent: low.exponent,
        }
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
    #[inline]
    fn neg(self) -> Dyadic {
        let integer = match self.integer {
            Integer::Short(value) if value > i128::MIN => Integer::Short(-value),
            value => Integer::Long(-value.long()),
        };
        let exponent = self.exponent;
        Dyadic { integer, exponent }
    }
}

impl Mul for Dyadic {
    type Output = Dyadic;
    #[inline]
    fn mul(self, other: Dyadic) -> Dyadic {
        let exponent = self.exponent + other.exponent;
        let integer = match (self.integer, other.integer) {
            (Integer::Short(0), _) | (_, Integer::Short(0)) => Integer::Short(0),
            (Integer::Short(a), Integer::Short(b)) => match a.checked_mul(b) {
                Some(product) => Integer::Short(product),
                None => Integer::Long(BigInt::from(a) * b),
            },
            (a, b) => Integer::Long(a.long() * b.long()),
        };
        Dyadic { integer, exponent }
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
