//! Numbers with few bits, on which `f64` arithmetic is exact. Where rays hit edges or shared planes
//! exactly, coordinates tend to be such numbers: integers, halves, or multiples of a unit.
//!
//! # Why no operation rounds
//!
//! Let points be multiples of a unit and below 2¹⁵ units, and directions (of rays, and normals of
//! planes) multiples of another unit and below 2¹⁵ of those. An exact decision about a plane or a
//! triangle subtracts points, multiplies at most three factors, of which at most one is a direction,
//! or two directions, and adds up at most three products:
//!
//! 1. p − e is below 2¹⁶, so a component of a cross product of two differences is below 2³³, and its
//!    dot product with a direction below 3 × 2⁴⁸. The dot product with a third difference is below
//!    3 × 2⁴⁹ < 2⁵¹. The sum of three dot products with a direction is below 2⁵².
//! 2. All of these are integers in their unit. An `f64` holds every integer up to 2⁵³.
//! 3. Units are from 2⁻¹⁵⁰ to 2¹⁵⁰, so that products neither underflow nor overflow.

use std::cmp::Ordering;

use crate::double_double::DoubleDouble;
use crate::number::{Real, exponent};
use crate::vector::Vector;

/// The bits that numbers may have, from the highest of the largest to the lowest of any.
const BITS: i32 = 15;

/// The largest number may have these magnitudes, unless it is 0: 2⁻¹³⁰ to 2¹⁵⁰.
const MAGNITUDES: std::ops::Range<f64> = 7.4e-40..1.4e45;

/// Whether these vectors have so few bits that sums and products of them are exact.
#[inline(always)]
pub fn are_short<const N: usize>(vectors: [Vector<f64>; N]) -> bool {
    let largest = vectors.map(Vector::largest).into_iter().fold(0.0, f64::max);
    if !(MAGNITUDES.contains(&largest) || largest == 0.0) {
        return false;
    }
    // In this sum, the last bit of the significand is the unit, so numbers with lower bits are
    // rounded. A NaN equals nothing.
    let rounding = 1.5f64.times_power_of_two(exponent(largest) + 52 + 1 - BITS);
    let is_short = |number: f64| (number + rounding) - rounding == number;
    let mut numbers = vectors.into_iter().flat_map(Vector::array);
    numbers.all(is_short)
}

/// The t of such a fraction, if it is not below `min_t`. It is rounded once, by the division, and a
/// rounded t lies on the wrong side of no number.
pub fn at_least(min_t: f64, [p, q]: [f64; 2]) -> Option<f64> {
    if q == 0.0 {
        return None;
    }
    // Adding 0 turns −0 into 0.
    let t = p / q + 0.0;
    let is_late = match t == min_t {
        true => compare([p, q], [min_t, 1.0]).is_ge(),
        false => t > min_t,
    };
    is_late.then_some(t)
}

/// Compares two fractions of [`short_fraction`](super::Filtered::short_fraction). The products are
/// exact: their units are from 2⁻⁹⁰⁰ on, and they are below 2¹⁰¹⁰.
pub fn compare([p, q]: [f64; 2], [r, s]: [f64; 2]) -> Ordering {
    let (left, right) = (DoubleDouble::product(p, s), DoubleDouble::product(r, q));
    let order = left.partial_cmp(&right).expect("they are finite");
    match (q < 0.0) == (s < 0.0) {
        true => order,
        false => order.reverse(),
    }
}
