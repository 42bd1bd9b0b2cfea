use dashu_int::UBig;
use dashu_int::ops::BitTest;
use dashu_ratio::Relaxed;

use super::{fraction, sign};
use crate::number::{Real, exponent};
use crate::question::Data;

/// The true answer to a question.
#[derive(Clone, Debug, Default)]
pub struct Truth {
    /// The first intersection, if there is one.
    pub t: Option<Root>,
    /// A sphere's other root, which a kernel may return by mistake.
    pub other: Option<Root>,
    /// Whether these two are further apart than the sphere's radius.
    pub are_apart: bool,
    /// Whether an exact equality decides: a tangent ray, a hit on an edge, t = `min_t`. Such a
    /// question has a true answer, but a kernel is not blamed for giving another.
    pub is_tie: bool,
}

impl Truth {
    /// A miss, which may be a tie.
    pub fn miss(is_tie: bool) -> Truth {
        Truth {
            is_tie,
            ..Truth::default()
        }
    }

    /// The only intersection with the line: a hit if t is not below `min_t`.
    pub fn only(t: Relaxed, min_t: f64, is_tie: bool) -> Truth {
        match sign(&(&t - fraction(min_t))) {
            -1 => Truth::miss(false),
            beyond => Truth {
                t: Some(Root::from(t)),
                is_tie: is_tie || beyond == 0,
                ..Truth::default()
            },
        }
    }
}

/// A true t: exact, or correct to more than 300 bits.
#[derive(Clone, Debug)]
pub struct Root {
    /// The number as a fraction.
    pub exact: Relaxed,
    /// `exact` = (`high` + `low`) × 2^`exponent`, to 106 bits, with |`high`| from 1 to 2.
    high: f64,
    low: f64,
    exponent: i32,
}

impl From<Relaxed> for Root {
    fn from(exact: Relaxed) -> Root {
        if sign(&exact) == 0 {
            return Root {
                exact,
                high: 0.0,
                low: 0.0,
                exponent: -100_000,
            };
        }
        let (_, numerator) = exact.numerator().clone().into_parts();
        let guess = numerator.bit_len() as i32 - exact.denominator().bit_len() as i32;
        let shift = |power: i32| match power >= 0 {
            true => Relaxed::from(UBig::ONE << power as usize),
            false => fraction(1.0) / Relaxed::from(UBig::ONE << -power as usize),
        };
        let near_one = &exact * shift(-guess);
        let adjust = exponent(near_one.to_f64().value());
        let scaled = near_one * shift(-adjust);
        let high = scaled.to_f64().value();
        let low = (scaled - fraction(high)).to_f64().value();
        Root {
            exact,
            high,
            low,
            exponent: guess + adjust,
        }
    }
}

impl Root {
    /// Whether it is within the range of a type.
    pub fn fits(&self, data: Data) -> bool {
        self.exponent <= exponent(data.largest()) && self.value().abs() <= data.largest()
    }

    /// The nearest `f64`.
    pub fn value(&self) -> f64 {
        let power = self.exponent.clamp(-3000, 3000);
        self.high.times_power_of_two(power)
    }

    /// The relative error of an answer; for a true t of 0, the absolute error.
    pub fn relative_error(&self, answer: f64) -> f64 {
        let near_one = answer.times_power_of_two(-self.exponent);
        match self.high == 0.0 {
            true => answer.abs(),
            false => ((near_one - self.high) - self.low).abs() / self.high.abs(),
        }
    }

    /// The error of an answer, in ulp of the true t in that type.
    pub fn error_in_ulp(&self, answer: f64, data: Data) -> f64 {
        let last_place = (self.exponent - data.digits() + 1).max(data.smallest_exponent());
        if self.high == 0.0 {
            return answer.abs().times_power_of_two((-last_place).min(2000));
        }
        let near_one = answer.times_power_of_two(-self.exponent);
        let error = ((near_one - self.high) - self.low).abs();
        error.times_power_of_two(self.exponent - last_place)
    }
}
