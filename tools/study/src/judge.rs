//! Judges one kernel's answers to one set of questions by the true answers.

use serde::Serialize;

use crate::contestants::Contestant;
use crate::oracle::{HasTruth, Root, Truth};
use crate::question::{Data, Question};

/// The result. Two sorts of questions are left out: ties, which an exact equality decides, such as
/// a tangent ray, and those whose true t exceeds the type's largest number.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Tally {
    /// Questions that were judged.
    pub asked: u64,
    /// Questions whose true answer is a hit.
    pub hits: u64,
    /// Misses that were answered with a hit.
    pub false_hits: u64,
    /// Hits that were answered with a miss.
    pub false_misses: u64,
    /// Hits that were answered with the t of the sphere's other side.
    pub wrong_roots: u64,
    /// Answers whose t is infinite or NaN.
    pub not_finite: u64,
    /// The median error of t in ulp, over true hits with a finite answer.
    pub median_ulp: Option<f64>,
}

impl Tally {
    /// The number of wrong decisions.
    pub fn wrong(&self) -> u64 {
        self.false_hits + self.false_misses + self.wrong_roots
    }

    /// The share of wrong decisions.
    pub fn wrong_share(&self) -> f64 {
        self.wrong() as f64 / self.asked.max(1) as f64
    }
}

/// The median and the largest error; `None` if there are no errors.
pub fn median_and_worst(errors: impl IntoIterator<Item = f64>) -> [Option<f64>; 2] {
    let mut errors: Vec<f64> = errors.into_iter().collect();
    errors.sort_by(f64::total_cmp);
    [errors.get(errors.len() / 2), errors.last()].map(Option::<&f64>::copied)
}

/// With no wrong decision in n, the true share is at most 3/n with 95 % confidence
/// (Hanley & Lippman-Hand, "If nothing goes wrong, is everything all right?", *JAMA*
/// 249, 1983: the rule of three).
pub fn rule_of_three(asked: u64) -> f64 {
    3.0 / asked.max(1) as f64
}

/// Roots that are at most this many ulp apart are not told apart. From very far away, even the
/// best t of the type may be nearer to the other root.
const APART: f64 = 64.0;

/// Whether t is that of the sphere's other side: nearer to the other root, if the roots are further
/// apart than the radius. Nearly tangent roots are not told apart either: their error is measured
/// instead.
fn is_of_other_side(truth: &Truth, root: &Root, t: f64, data: Data) -> bool {
    let Some(other) = truth.other.as_ref().map(|other| other.value) else {
        return false;
    };
    truth.are_apart
        && (t - other).abs() < (t - root.value).abs()
        && root.error_in_ulp(other, data) > APART
}

/// Judges a kernel's answers to questions with known true answers. Also returns the error in ulp of
/// each finite t that is not a wrong decision, with the index of its question.
pub fn judge<S: HasTruth>(
    kernel: &Contestant<S>,
    questions: &[Question<S>],
    truths: &[Truth],
) -> (Tally, Vec<(usize, f64)>) {
    let data = kernel.data;
    let mut tally = Tally::default();
    let mut errors = Vec::new();
    for (at, (question, truth)) in questions.iter().zip(truths).enumerate() {
        if truth.is_tie || truth.t.as_ref().is_some_and(|t| !t.fits(data)) {
            continue;
        }
        tally.asked += 1;
        tally.hits += u64::from(truth.t.is_some());
        match (&truth.t, (kernel.answer)(question)) {
            (_, Some(t)) if !t.is_finite() => tally.not_finite += 1,
            (None, None) => (),
            (None, Some(_)) => tally.false_hits += 1,
            (Some(_), None) => tally.false_misses += 1,
            (Some(root), Some(t)) if is_of_other_side(truth, root, t, data) => {
                tally.wrong_roots += 1;
            }
            (Some(root), Some(t)) => errors.push((at, root.error_in_ulp(t, data))),
        }
    }
    [tally.median_ulp, _] = median_and_worst(errors.iter().map(|error| error.1));
    (tally, errors)
}
