//! Questions with one number that is no number, or no ordinary one.

use std::cell::Cell;

use crate::contestants::Contested;
use crate::question::{Data, Question};
use crate::shape::Shape;

/// What takes a number's place.
pub const SPOILERS: [(&str, f64); 7] = [
    ("NaN", f64::NAN),
    ("+∞", f64::INFINITY),
    ("−∞", f64::NEG_INFINITY),
    ("smallest", 5e-324),
    ("largest", f64::MAX),
    ("0", 0.0),
    ("−0", -0.0),
];

/// The spoiler as a number of a type: its smallest, its largest.
pub fn spoiler(value: f64, data: Data) -> f64 {
    match (value, data) {
        (5e-324, Data::F32) => f64::from(f32::from_bits(1)),
        (f64::MAX, Data::F32) => f64::from(f32::MAX),
        _ => value,
    }
}

/// The question with its number at `place` replaced, counted through shape, ray and
/// min_t; `None` behind the last.
pub fn spoilt<S: Contested + Shape<With<f64> = S>>(
    question: &Question<S>,
    place: usize,
    value: f64,
) -> Option<Question<S>> {
    let at = Cell::new(0);
    let replace = |number: f64| {
        at.set(at.get() + 1);
        if at.get() == place + 1 { value } else { number }
    };
    let spoilt = question.map(replace, replace, replace, replace);
    (at.get() > place).then_some(spoilt)
}
