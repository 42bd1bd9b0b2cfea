//! Judges one kernel's answers to one set of questions by the true answers.

use serde::Serialize;

use crate::contestant::Contestant;
use crate::oracle::{HasTruth, Truth};
use crate::question::{Data, Question};

/// The result. Ties are only counted, not judged. Questions whose true t exceeds the type's
/// largest number are left out.
#[derive(Clone, Debug, Default, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Tally {
    /// Questions that were judged.
    pub asked: u64,
    /// Questions that an exact equality decides, such as a tangent ray.
    pub ties: u64,
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
    /// The largest error of t in ulp, over the same hits.
    pub worst_ulp: Option<f64>,
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

/// The verdict on one answer. A right hit has its error in ulp.
enum Verdict {
    Right(Option<f64>),
    FalseHit,
    FalseMiss,
    WrongRoot,
    NotFinite,
}

fn verdict<S: HasTruth>(
    data: Data,
    question: &Question<S>,
    truth: &Truth,
    answer: Option<f64>,
) -> Verdict {
    match (&truth.t, answer) {
        (_, Some(t)) if !t.is_finite() => Verdict::NotFinite,
        (None, None) => Verdict::Right(None),
        (None, Some(_)) => Verdict::FalseHit,
        (Some(_), None) => Verdict::FalseMiss,
        (Some(root), Some(t)) => {
            let error = root.error_in_ulp(t, data);
            let other = truth.other.as_ref().map(|other| other.value());
            let apart = other.map_or(0.0, |other| root.error_in_ulp(other, data));
            match other.filter(|_| apart > APART) {
                Some(other) if is_of_other_side(question, root.value(), other, t) => {
                    Verdict::WrongRoot
                }
                _ => Verdict::Right(Some(error)),
            }
        }
    }
}

/// Roots that are at most this many ulp apart are not told apart. From very far away, even the
/// best t of the type may be nearer to the other root.
const APART: f64 = 64.0;

/// Whether t is nearer to the other root, if the roots are further apart than the radius.
/// Nearly tangent roots are not told apart either: their error is measured instead.
fn is_of_other_side<S: HasTruth>(question: &Question<S>, root: f64, other: f64, t: f64) -> bool {
    let [lengths, _, direction] = question.numbers();
    // The last length of a sphere is its radius.
    let radius = lengths.last().copied().unwrap_or(0.0).abs();
    let length = direction.into_iter().fold(0.0, f64::hypot);
    (other - root).abs() > radius / length && (t - other).abs() < (t - root).abs()
}

/// Judges a kernel's answers to questions with known true answers.
pub fn judge<S: HasTruth>(
    kernel: &Contestant<S>,
    questions: &[Question<S>],
    truths: &[Truth],
) -> Tally {
    judge_each(kernel, questions, truths).0
}

/// Like [`judge`], and also returns the error in ulp of each finite t that is not a wrong decision,
/// with the index of its question.
pub fn judge_each<S: HasTruth>(
    kernel: &Contestant<S>,
    questions: &[Question<S>],
    truths: &[Truth],
) -> (Tally, Vec<(usize, f64)>) {
    let data = kernel.data;
    let mut tally = Tally::default();
    let mut errors = Vec::new();
    for (at, (question, truth)) in questions.iter().zip(truths).enumerate() {
        if truth.is_tie {
            tally.ties += 1;
            continue;
        }
        if truth.t.as_ref().is_some_and(|t| !t.fits(data)) {
            continue;
        }
        tally.asked += 1;
        tally.hits += u64::from(truth.t.is_some());
        match verdict(data, question, truth, (kernel.answer)(question)) {
            Verdict::Right(error) => errors.extend(error.map(|error| (at, error))),
            Verdict::FalseHit => tally.false_hits += 1,
            Verdict::FalseMiss => tally.false_misses += 1,
            Verdict::WrongRoot => tally.wrong_roots += 1,
            Verdict::NotFinite => tally.not_finite += 1,
        }
    }
    [tally.median_ulp, tally.worst_ulp] = median_and_worst(errors.iter().map(|error| error.1));
    (tally, errors)
}
