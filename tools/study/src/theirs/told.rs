//! Recorded answers, read in the order in which they were asked.

use pinhole::kind::Answer;

use super::DATA;
use crate::judge::{Answers, Tally, judge_each};
use crate::oracle::{Known, Truth};
use crate::question::{Data, Question};

/// The answers of one part that are not read yet.
pub struct Told<'a>(&'a [Option<Answer>]);

impl<'a> Told<'a> {
    /// From the first on.
    pub fn new(answers: &'a [Option<Answer>]) -> Told<'a> {
        Told(answers)
    }

    /// The next so many answers; `None` for what was not answered.
    pub fn next(&mut self, count: usize) -> Vec<Option<Option<f64>>> {
        let (these, rest) = self.0.split_at(count.min(self.0.len()));
        self.0 = rest;
        let mut these: Vec<_> = these
            .iter()
            .map(|answer| answer.as_ref().and_then(t))
            .collect();
        these.resize(count, None);
        these
    }

    /// Judges the next answers: to these questions, then to the same with their numbers
    /// near 1. What was not answered does not count.
    pub fn judged<S: Known>(
        &mut self,
        questions: &[Question<S>],
        truths: &[Truth],
    ) -> (Tally, Vec<(usize, f64)>) {
        let (given, again) = (self.next(questions.len()), self.next(questions.len()));
        let is_answered = |at: &usize| given[*at].is_some() && again[*at].is_some();
        let places: Vec<usize> = (0..questions.len()).filter(is_answered).collect();
        let recorded = Recorded {
            given: places.iter().map(|at| given[*at].flatten()).collect(),
            again: places.iter().map(|at| again[*at].flatten()).collect(),
        };
        let questions: Vec<_> = places.iter().map(|at| questions[*at]).collect();
        let truths: Vec<_> = places.iter().map(|at| truths[*at].clone()).collect();
        let (tally, mut errors) = judge_each(&recorded, &questions, &truths);
        for (at, _) in &mut errors {
            *at = places[*at];
        }
        (tally, errors)
    }
}

/// The t of a hit, or that there is none; `None` for what answers no such question.
fn t(answer: &Answer) -> Option<Option<f64>> {
    match answer {
        Answer::Hit(hit) => Some(hit.map(|hit| hit.intersection.t)),
        _ => None,
    }
}

/// Answers to questions, place by place.
struct Recorded {
    given: Vec<Option<f64>>,
    again: Vec<Option<f64>>,
}

impl<S> Answers<S> for Recorded {
    fn data(&self) -> Data {
        DATA
    }

    fn answer(&self, at: usize, _: &Question<S>) -> Option<f64> {
        self.given[at]
    }

    fn answer_near_one(&self, at: usize, _: &Question<S>) -> Option<f64> {
        self.again[at]
    }
}
