//! The operations that kernels need from a number, so that one kernel serves `f32` and `f64`.

use std::fmt::Debug;

use num_traits::Float;

/// `f32` or `f64`: a binary floating-point number, rounded to nearest (IEEE 754).
pub trait Real: Float + Debug + Send + Sync + 'static {
    /// Rounds to this type.
    fn of(value: f64) -> Self;
    /// The same number as an `f64`.
    fn wide(self) -> f64;
    /// self × 2^`power`, exact unless the result leaves the type's range.
    fn times_power_of_two(self, power: i32) -> Self;
}

/// The largest relative error of one rounding in `f64`.
pub const U: f64 = 1.110_223_024_625_156_5e-16;
/// The square root of [`U`], rounded up.
pub const ROOT_OF_UNIT: f64 = 1.053_671_212_772_351e-8;
/// The smallest normal `f64`. Products below it lose digits.
pub const TINY: f64 = f64::MIN_POSITIVE;

/// The e with 2^e ≤ |value| < 2^(e + 1); 0 for 0, infinities and NaN.
#[inline]
pub fn exponent(value: f64) -> i32 {
    let field = |bits: u64| ((bits >> 52) & 0x7ff) as i32;
    match field(value.to_bits()) {
        0x7ff => 0,
        0 if value == 0.0 => 0,
        0 => field((value * 2f64.powi(64)).to_bits()) - 1023 - 64,
        e => e - 1023,
    }
}

macro_rules! real {
    ($type:ident, $bits:ident, $mantissa:expr) => {
        impl Real for $type {
            #[inline(always)]
            fn of(value: f64) -> Self {
                value as $type
            }
            #[inline(always)]
            fn wide(self) -> f64 {
                self.into()
            }
            #[inline(always)]
            fn times_power_of_two(self, power: i32) -> Self {
                let two_to = |power: i32| {
                    $type::from_bits(((power + $type::MAX_EXP - 1) as $bits) << $mantissa)
                };
                if power.abs() < $type::MAX_EXP - 1 {
                    return self * two_to(power);
                }
                // 2^power itself may be out of range. Multiply by three factors instead: they
                // are in range, unless the result is far out of it.
                #[cold]
                #[inline(never)]
                fn by_three(value: $type, power: i32, two_to: impl Fn(i32) -> $type) -> $type {
                    let two_to =
                        |power: i32| two_to(power.clamp(2 - $type::MAX_EXP, $type::MAX_EXP - 1));
                    let (third, rest) = (power / 3, power - 2 * (power / 3));
                    value * two_to(third) * two_to(third) * two_to(rest)
                }
                by_three(self, power, two_to)
            }
        }
    };
}

real!(f32, u32, 23);
real!(f64, u64, 52);
