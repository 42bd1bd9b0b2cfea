use dashu_int::ops::Abs;
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
    /// The nearest `f64`.
    pub value: f64,
}

impl From<Relaxed> for Root {
    fn from(exact: Relaxed) -> Root {
        let value = exact.to_f64().value();
        Root { exact, value }
    }
}

impl Root {
    /// Whether it is within the range of a type.
    pub fn fits(&self, data: Data) -> bool {
        self.value.abs() <= data.largest()
    }

    /// The relative error of an answer; for a true t of 0, the absolute error.
    pub fn relative_error(&self, answer: f64) -> f64 {
        match sign(&self.exact) {
            0 => answer.abs(),
            _ => self.error(answer, &self.exact),
        }
    }

    /// The error of an answer, in ulp of the true t in that type.
    pub fn error_in_ulp(&self, answer: f64, data: Data) -> f64 {
        let last_place = match self.value == 0.0 {
            true => i32::MIN,
            false => exponent(self.value) - data.digits() + 1,
        };
        let last_place = last_place.max(data.smallest_exponent());
        self.error(answer, &fraction(1f64.times_power_of_two(last_place)))
    }

    /// The error of an answer, divided by the magnitude of `unit`, and rounded once.
    fn error(&self, answer: f64, unit: &Relaxed) -> f64 {
        match Relaxed::try_from(answer) {
            Ok(answer) => ((&self.exact - answer) / unit).abs().to_f64().value(),
            Err(_) => f64::INFINITY,
        }
    }
}
