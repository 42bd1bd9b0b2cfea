//! Integers times powers of two: every finite float is one, and so is every sum and
//! product of floats, without rounding, overflow or underflow. The adaptive kernels
//! decide with these what their filters leave open.
//!
//! Why not expansions (Shewchuk, *Discrete Comput. Geom.* 18, 1997), which are faster:
//! they are exact only while no partial product underflows, and the extremes are what
//! this package is about. The oracle uses another's rationals: the two share no code.

use std::cmp::Ordering;
use std::ops::{Add, Mul, Neg, Sub};

use smallvec::SmallVec;

use crate::double_double::DoubleDouble;
use crate::vector::Vector;

/// As many limbs as everyday numbers need are kept in place; more go to the heap.
const IN_PLACE: usize = 8;
type Limbs = SmallVec<[u64; IN_PLACE]>;

/// ±`limbs` × 2^`exponent`.
#[derive(Clone, Debug)]
pub struct Dyadic {
    negative: bool,
    /// Lowest first; the highest is not 0. None at all for zero.
    limbs: Limbs,
    exponent: i64,
}

impl Dyadic {
    /// A finite number, exactly.
    pub fn of(value: f64) -> Dyadic {
        let bits = value.to_bits();
        let (field, fraction) = ((bits >> 52) & 0x7ff, bits & ((1 << 52) - 1));
        debug_assert!(field < 0x7ff, "only finite numbers are dyadic");
        let (mantissa, exponent) = match field {
            0 => (fraction, -1074),
            _ => (fraction | (1 << 52), field as i64 - 1075),
        };
        let limbs = trimmed(Limbs::from_slice(&[mantissa]));
        Dyadic {
            negative: bits >> 63 == 1,
            limbs,
            exponent,
        }
    }

    /// −1, 0 or 1.
    pub fn sign(&self) -> i32 {
        match (self.limbs.is_empty(), self.negative) {
            (true, _) => 0,
            (false, true) => -1,
            (false, false) => 1,
        }
    }

    /// The limbs, as they are with an exponent that is smaller or the same.
    #[inline]
    fn limbs_at(&self, exponent: i64) -> Limbs {
        let shift = (self.exponent - exponent) as usize;
        let (whole, part) = (shift / 64, shift % 64);
        limbs(whole + self.limbs.len() + 1, |to| {
            let mut carry = 0;
            for (limb, place) in self.limbs.iter().zip(&mut to[whole..]) {
                *place = limb << part | carry;
                carry = (limb >> 1) >> (63 - part);
            }
            to[whole + self.limbs.len()] = carry;
        })
    }

    /// `self` + `other`, or − `other`.
    #[inline]
    fn plus(&self, other: &Dyadic, is_less: bool) -> Dyadic {
        let other_negative = other.negative != is_less;
        match (self.sign(), other.sign()) {
            (_, 0) => return self.clone(),
            (0, _) if is_less => return -other.clone(),
            (0, _) => return other.clone(),
            _ => (),
        }
        let exponent = self.exponent.min(other.exponent);
        let (a, b) = (self, other);
        let (negative, limbs) = match self.negative == other_negative {
            // Of the two, one is as it is.
            true if a.exponent == exponent => (a.negative, sum(&b.limbs_at(exponent), &a.limbs)),
            true => (a.negative, sum(&a.limbs_at(exponent), &b.limbs)),
            false => {
                let (a, b) = (a.limbs_at(exponent), b.limbs_at(exponent));
                match compared(&a, &b) {
                    Ordering::Less => (other_negative, difference(b, &a)),
                    _ => (self.negative, difference(a, &b)),
                }
            }
        };
        Dyadic {
            negative,
            limbs,
            exponent,
        }
    }

    /// The first 106 bits and where they stand: `value` × 2^`exponent`, `value.high` in
    /// [1, 2).
    pub fn leading(&self) -> (DoubleDouble, i64) {
        let Some(top) = self.limbs.last() else {
            return (0.0.into(), 0);
        };
        let count = self.limbs.len() as i64 * 64 - i64::from(top.leading_zeros());
        let bits = |from_top: i64| {
            // 53 bits, of which the highest is so far below the top.
            let low = count - from_top - 53;
            let bit = |at: i64| match at {
                0.. => self.limbs[at as usize / 64] >> (at % 64) & 1,
                _ => 0,
            };
            (0..53).fold(0, |sum, at| sum | bit(low + at) << at) as f64
        };
        let sign = f64::from(self.sign());
        let (high, low) = (bits(0) * 2f64.powi(-52), bits(53) * 2f64.powi(-105));
        let value = DoubleDouble::sum(sign * high, sign * low);
        (value, self.exponent + count - 1)
    }
}

/// So many limbs, which are 0 before they are filled in.
#[inline(always)]
fn limbs(count: usize, fill: impl FnOnce(&mut [u64])) -> Limbs {
    let mut in_place = [0; IN_PLACE];
    let limbs = match in_place.get_mut(..count) {
        Some(few) => {
            fill(few);
            Limbs::from_buf_and_len(in_place, count)
        }
        None => {
            let mut many = vec![0; count];
            fill(&mut many);
            Limbs::from_vec(many)
        }
    };
    trimmed(limbs)
}

#[inline(always)]
fn trimmed(mut limbs: Limbs) -> Limbs {
    let zeros = limbs.iter().rev().take_while(|limb| **limb == 0).count();
    limbs.truncate(limbs.len() - zeros);
    limbs
}

fn compared(a: &[u64], b: &[u64]) -> Ordering {
    let longer = a.len().cmp(&b.len());
    longer.then_with(|| a.iter().rev().cmp(b.iter().rev()))
}

#[inline]
fn sum(a: &[u64], b: &[u64]) -> Limbs {
    let (longer, shorter) = if a.len() < b.len() { (b, a) } else { (a, b) };
    limbs(longer.len() + 1, |to| {
        let mut carry = 0;
        for (at, limb) in longer.iter().enumerate() {
            let total =
                u128::from(*limb) + u128::from(shorter.get(at).copied().unwrap_or(0)) + carry;
            (to[at], carry) = (total as u64, total >> 64);
        }
        to[longer.len()] = carry as u64;
    })
}

/// `a` − `b`, where a ≥ b.
#[inline]
fn difference(mut a: Limbs, b: &[u64]) -> Limbs {
    let mut borrow = false;
    for (at, limb) in a.iter_mut().enumerate() {
        let (less, first) = limb.overflowing_sub(b.get(at).copied().unwrap_or(0));
        let (less, second) = less.overflowing_sub(borrow.into());
        (*limb, borrow) = (less, first || second);
    }
    trimmed(a)
}

impl Add for &Dyadic {
    type Output = Dyadic;
    fn add(self, other: &Dyadic) -> Dyadic {
        self.plus(other, false)
    }
}

impl Neg for Dyadic {
    type Output = Dyadic;
    fn neg(self) -> Dyadic {
        Dyadic {
            negative: !self.negative,
            ..self
        }
    }
}

impl Sub for &Dyadic {
    type Output = Dyadic;
    fn sub(self, other: &Dyadic) -> Dyadic {
        self.plus(other, true)
    }
}

impl Mul for &Dyadic {
    type Output = Dyadic;
    fn mul(self, other: &Dyadic) -> Dyadic {
        let limbs = limbs(self.limbs.len() + other.limbs.len(), |to| {
            for (at, a) in self.limbs.iter().enumerate() {
                let mut carry = 0;
                for (b, place) in other.limbs.iter().zip(&mut to[at..]) {
                    let total = u128::from(*a) * u128::from(*b) + u128::from(*place) + carry;
                    (*place, carry) = (total as u64, total >> 64);
                }
                to[at + other.limbs.len()] = carry as u64;
            }
        });
        Dyadic {
            negative: self.negative != other.negative,
            limbs,
            exponent: self.exponent + other.exponent,
        }
    }
}

/// A vector of such numbers.
#[derive(Clone, Debug)]
pub struct DyadicVector(pub [Dyadic; 3]);

impl DyadicVector {
    /// A vector of finite numbers, exactly.
    pub fn of(vector: Vector<f64>) -> DyadicVector {
        DyadicVector(vector.array().map(Dyadic::of))
    }

    /// The dot product.
    pub fn dot(&self, other: &DyadicVector) -> Dyadic {
        let ([a, b, c], [x, y, z]) = (&self.0, &other.0);
        &(&(a * x) + &(b * y)) + &(c * z)
    }

    /// The cross product.
    pub fn cross(&self, other: &DyadicVector) -> DyadicVector {
        let ([a, b, c], [x, y, z]) = (&self.0, &other.0);
        let minor = |p: &Dyadic, q: &Dyadic, r: &Dyadic, s: &Dyadic| &(p * q) - &(r * s);
        DyadicVector([minor(b, z, c, y), minor(c, x, a, z), minor(a, y, b, x)])
    }
}

impl Sub for &DyadicVector {
    type Output = DyadicVector;
    fn sub(self, other: &DyadicVector) -> DyadicVector {
        let ([a, b, c], [x, y, z]) = (&self.0, &other.0);
        DyadicVector([a - x, b - y, c - z])
    }
}
