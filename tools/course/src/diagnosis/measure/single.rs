//! Answers in single precision: every number is one that `f32` holds.

use pinhole::part::Part;

use super::claim::Claim;
use super::sample::Sample;
use super::{Finding, LEAST, Measurement, capital};

/// The sentence about the parts that have single precision, if any do.
pub fn found(both: &[&Sample]) -> Option<Measurement> {
    let described = both.first()?.right.as_ref()?;
    let parts: Vec<usize> = (0..described.len())
        .filter(|part| is_single(both, *part))
        .collect();
    let about = described[*parts.first()?].name;
    Some(Measurement {
        finding: Finding {
            about: about.into(),
            says: format!(
                "{} has single precision in every answer, and rounding spoils the last digits: \
                 is something `f32`?",
                capital(about)
            ),
            is_law: true,
        },
        claim: Claim::Single { part: parts[0] },
    })
}

/// Whether `f32` holds every given value of a part. Short numbers such as 0.5 prove nothing, so
/// there must be enough others.
pub fn is_single(both: &[&Sample], part: usize) -> bool {
    let is_told = |described: &Part| !described.is_object() && described.unit.is_empty();
    let given = both.iter().filter_map(|sample| sample.given.as_ref());
    let told = given
        .filter_map(|parts| parts.get(part))
        .filter(|it| is_told(it));
    let values: Vec<f64> = told.flat_map(|part| part.values.clone()).collect();
    let is_short = |value: &&f64| (**value * SHORT).fract() == 0.0;
    let finite = || values.iter().filter(|value| value.is_finite());
    let long = finite().filter(|value| !is_short(value)).count();
    long >= LEAST && finite().all(|value| f64::from(*value as f32) == *value)
}

/// A number is short if it is a multiple of 1/`SHORT`.
const SHORT: f64 = 1024.0;
