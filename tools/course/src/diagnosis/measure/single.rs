//! Answers in single precision: `f32` can hold every number in them.

use pinhole::part::Part;

use super::claim::Claim;
use super::sample::{QuestionsAndAnswers, Sample};
use super::{Finding, LEAST, Measurement, capital};

/// The sentence about the parts that have single precision, if any do.
pub fn found(films: &[QuestionsAndAnswers<'_>], both: &[&Sample]) -> Option<Measurement> {
    // In other tasks, an answer may repeat a number of its question, and questions have single
    // precision.
    if !films.iter().all(|film| film.questions.kind().takes_shape()) {
        return None;
    }
    let described = both.first()?.right.as_ref()?;
    let parts: Vec<usize> = (0..described.len())
        .filter(|part| is_single(both, *part))
        .collect();
    let about = described[*parts.first()?].name;
    Some(Measurement {
        finding: Finding {
            about: about.into(),
            says: format!(
                "{} has only single precision in every answer. Do you use `f32` somewhere?",
                capital(about)
            ),
            is_law: true,
        },
        claim: Claim::Single { part: parts[0] },
    })
}

/// Whether `f32` can hold every given value of a part. Short numbers such as 0.5 prove nothing, so
/// there must be enough others. A vector that is wrong by more than rounding proves nothing either:
/// it may be a copy of one in the question, such as a plane's stored normal, and questions have
/// single precision.
pub fn is_single(both: &[&Sample], part: usize) -> bool {
    let is_told = |described: &Part| !described.is_object() && described.unit.is_empty();
    let given = both.iter().filter_map(|sample| sample.given.as_ref());
    let told = given
        .filter_map(|parts| parts.get(part))
        .filter(|it| is_told(it));
    let is_vector = told.clone().any(|part| part.values.len() > 1);
    let values: Vec<f64> = told.flat_map(|part| part.values.clone()).collect();
    let is_short = |value: &&f64| (**value * SHORT).fract() == 0.0;
    let finite = || values.iter().filter(|value| value.is_finite());
    let long = finite().filter(|value| !is_short(value)).count();
    let near = both.iter().filter(|sample| is_near(sample, part)).count();
    long >= LEAST
        && (!is_vector || 2 * near > both.len())
        && finite().all(|value| f64::from(*value as f32) == *value)
}

/// Whether a part is wrong by no more than rounding.
fn is_near(sample: &Sample, part: usize) -> bool {
    let apart = |(right, given): (&[f64], &[f64])| {
        let pairs = right.iter().zip(given);
        pairs.fold(0.0_f64, |apart, (right, given)| {
            apart.max((given - right).abs())
        })
    };
    let size = |values: &[f64]| values.iter().fold(0.0_f64, |size, it| size.max(it.abs()));
    sample
        .both(part)
        .is_some_and(|both| apart(both) <= ROUNDED * size(both.0))
}

/// A number is short if it is a multiple of 1/`SHORT`.
const SHORT: f64 = 1024.0;

/// The rounding that a few operations in single precision can add up to, relative to the value.
const ROUNDED: f64 = 1e-3;
