//! One question with its right answer and the one that was given, part by part.

use pinhole::judge::Golden;
use pinhole::kind::{Answer, Questions};
use pinhole::part::{Condition, Part, Quantity, Tally};

/// Questions, the answers that were given, and Mitsuba's.
#[derive(Clone, Copy)]
pub struct QuestionsAndAnswers<'a> {
    /// What was asked.
    pub questions: &'a Questions,
    /// The answers, in the questions' order.
    pub answers: &'a [Option<Answer>],
    /// How the steps of each answer were taken; empty if answers have no steps.
    pub tallies: &'a [Vec<Tally>],
    /// Mitsuba's answers.
    pub golden: &'a Golden,
}

/// One question and both answers.
pub struct Sample {
    /// The right answer; `None` if there is nothing.
    pub right: Option<Vec<Part>>,
    /// The answer that was given.
    pub given: Option<Vec<Part>>,
    /// How far each part may be off, in its own unit.
    slack: Vec<f64>,
    /// Numbers that belong to the question.
    pub quantities: Vec<Quantity>,
    /// Plausible wrong answers, by name. All samples have the same names in the same places.
    pub others: Vec<(&'static str, Option<Vec<Part>>)>,
    /// The conditions on the question and the right answer.
    pub conditions: Vec<Condition>,
    /// The conditions on the question and the answer that was given.
    pub conditions_given: Vec<Condition>,
    /// Whether laws are fitted to this sample. They are tested on the others.
    pub fits: bool,
}

/// Values that differ by at most this share of themselves count as the same, because they may be
/// computed in another order or rounded to 32 bits.
pub const SAME: f64 = 2e-5;

/// All questions of these films that were answered and are not exempt.
pub fn samples(films: &[QuestionsAndAnswers<'_>]) -> Vec<Sample> {
    let of_film = |film: &QuestionsAndAnswers<'_>| {
        let answered = film.answers.iter().enumerate();
        let samples = answered.filter_map(|(index, given)| film.sample(index, given.as_ref()?));
        samples.collect::<Vec<_>>()
    };
    let mut samples: Vec<Sample> = films.iter().flat_map(of_film).collect();
    align_others(&mut samples);
    samples
}

/// Gives all samples the same list of other answers, because a law knows one by its place. A
/// question that lacks one gets `None` there.
fn align_others(samples: &mut [Sample]) {
    let mut names: Vec<&'static str> = Vec::new();
    for (name, _) in samples.iter().flat_map(|sample| &sample.others) {
        if !names.contains(name) {
            names.push(name);
        }
    }
    for sample in samples {
        let mut own = std::mem::take(&mut sample.others);
        let mut find = |name: &str| {
            let place = own.iter().position(|(its, _)| *its == name)?;
            own.swap_remove(place).1
        };
        sample.others = names.iter().map(|name| (*name, find(name))).collect();
    }
}

impl QuestionsAndAnswers<'_> {
    fn sample(&self, index: usize, given: &Answer) -> Option<Sample> {
        let QuestionsAndAnswers {
            questions, golden, ..
        } = self;
        if golden.is_exempt(index) {
            return None;
        }
        let expected = questions.expected(golden.film(), index);
        let parts = |answer: &Answer| questions.parts(index, answer);
        let right = parts(&expected);
        let others = questions.others(index, &expected).into_iter();
        let slack = |part: &Part| {
            let samples = part.channels.iter();
            let tolerances = samples.filter_map(|name| golden.tolerance().channel(name));
            let widest = tolerances.map(|all| f64::from(all[index]));
            let widest = widest.fold(0.0, f64::max) / part.scale;
            match part {
                // An id is a name, so another id is never nearly right.
                part if part.is_object() => 0.0,
                part if part.is_limit => widest,
                _ => 2.0 * widest,
            }
        };
        Some(Sample {
            slack: right.iter().flatten().map(slack).collect(),
            given: parts(given),
            quantities: questions.quantities(index, &expected),
            others: others.map(|(name, other)| (name, parts(&other))).collect(),
            conditions: questions.conditions(index, &expected),
            conditions_given: questions.conditions(index, given),
            // Scatter the samples, because neighbours in a film may be alike (Knuth,
            // vol. 3, §6.4).
            fits: (index as u64 + 1).wrapping_mul(0x9E37_79B9_7F4A_7C15) >> 63 == 0,
            right,
        })
    }
}

impl Sample {
    /// The values of a part in both answers, if both have it.
    pub fn both(&self, part: usize) -> Option<(&[f64], &[f64])> {
        let (right, given) = (self.right.as_ref()?, self.given.as_ref()?);
        Some((&right.get(part)?.values, &given.get(part)?.values))
    }

    /// How far a value may be from `value` and still count as the same, if `value` is the
    /// right one multiplied by `stretch`.
    pub fn allowed(&self, part: usize, value: f64, stretch: f64) -> f64 {
        self.slack[part] * stretch.abs().max(1.0) + SAME * value.abs()
    }

    /// Whether a golden only limits a part.
    pub fn is_limited(&self, part: usize) -> bool {
        let right = self.right.as_ref().and_then(|parts| parts.get(part));
        right.is_some_and(|it| it.is_limit)
    }

    /// How large a part is, and how large it may be, if a golden limits it.
    pub fn limited(&self, part: usize) -> Option<(f64, f64)> {
        let (_, given) = self.both(part)?;
        let limit = (*given.first()?, self.slack[part]);
        self.is_limited(part).then_some(limit)
    }

    /// Whether both answers have this part and it is right.
    pub fn is_right(&self, part: usize) -> bool {
        let Some((right, given)) = self.both(part) else {
            return false;
        };
        // A small component of a large vector is as uncertain as the large ones.
        let size = right
            .iter()
            .fold(0.0_f64, |size, value| size.max(value.abs()));
        let mut pairs = right.iter().zip(given);
        pairs.all(|(right, given)| {
            !right.is_finite() || (given - right).abs() <= self.allowed(part, size, 1.0)
        })
    }

    /// Whether a part can be compared: both answers have it. All parts except the object are
    /// compared only where the object is right.
    pub fn is_comparable(&self, part: usize) -> bool {
        self.both(part).is_some() && (part == 0 || self.is_same_object())
    }

    /// Whether both answers hit the same object. If they don't, comparing other parts would tell us
    /// nothing.
    pub fn is_same_object(&self) -> bool {
        let parts = self.right.iter().flatten().enumerate();
        let mut objects = parts.filter(|(_, part)| part.is_object());
        objects.all(|(part, _)| self.is_right(part))
    }
}

impl Sample {
    /// Whether a part says which object is hit.
    pub fn is_object(&self, part: usize) -> bool {
        let described = self.right.as_ref().and_then(|parts| parts.get(part));
        described.is_some_and(Part::is_object)
    }
}
