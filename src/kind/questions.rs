//! Questions of one kind, as a question film holds them and a job sends them.

use std::ops::Range;
use std::path::Path;

use serde::{Deserialize, Serialize};

use super::{
    Answer, AnswerFn, BoundsQuestion, BoxQuestion, CameraQuestion, Kind, ObjectsQuestion, Question,
    SearchQuestion, ShapeQuestion, SoupQuestion, Test, TestResult, TreeQuestion, Unregistered,
    WireAnswer, cameras,
};
use crate::camera::Resolution;
use crate::error::Error;
use crate::fact::Fact;
use crate::film::{Film, Samples};
use crate::part::{Condition, Part, Quantity};
use crate::shape::ShapeKind;

/// Questions of one kind.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub enum Questions {
    /// See [`Kind::ViewingRay`].
    ViewingRay(#[serde(with = "cameras")] Vec<CameraQuestion>),
    /// See [`Kind::Intersect`].
    Intersect(Vec<ShapeQuestion>),
    /// See [`Kind::FirstHit`].
    FirstHit(Vec<ObjectsQuestion>),
    /// See [`Kind::Soup`].
    Soup(Vec<SoupQuestion>),
    /// See [`Kind::Bounds`].
    Bounds(Vec<BoundsQuestion>),
    /// See [`Kind::RayBox`].
    RayBox(Vec<BoxQuestion>),
    /// See [`Kind::Tree`].
    Tree(Vec<TreeQuestion>),
    /// See [`Kind::TreeSearch`].
    TreeSearch(Vec<SearchQuestion>),
}

impl Questions {
    /// Reads the question film at `path`, and its size. `task`, `kind` and `shape` are those in
    /// `assignment.toml`.
    ///
    /// # Errors
    /// If the film cannot be read, lacks a channel of this kind's questions, or holds a
    /// value that no question can have.
    pub fn read(
        path: &Path,
        task: &str,
        kind: Kind,
        shape: Option<ShapeKind>,
    ) -> Result<(Questions, Resolution), Error> {
        let film = Film::read(path)?;
        let questions = Questions::from_film(&film, kind, shape).map_err(|problem| {
            Error::new(
                path,
                format!("this is not a question film for `{task}`: {problem}"),
                "make the question films again: cargo pinhole golden render",
            )
        })?;
        Ok((questions, film.resolution()))
    }

    pub(super) fn from_film(
        film: &Film,
        kind: Kind,
        shape: Option<ShapeKind>,
    ) -> Result<Questions, String> {
        fn all<Q>(
            film: &Film,
            read: impl Fn(Samples<'_>) -> Result<Q, String>,
        ) -> Result<Vec<Q>, String> {
            let pixels = 0..film.resolution().pixels();
            pixels.map(|index| read(Samples::at(film, index))).collect()
        }
        Ok(match kind {
            Kind::ViewingRay => Questions::ViewingRay(all(film, CameraQuestion::read)?),
            Kind::Intersect => {
                let shape = shape.ok_or("the task names no shape")?;
                Questions::Intersect(all(film, |samples| ShapeQuestion::read(samples, shape))?)
            }
            Kind::FirstHit => Questions::FirstHit(all(film, ObjectsQuestion::read)?),
            Kind::Soup => Questions::Soup(all(film, SoupQuestion::read)?),
            Kind::Bounds => Questions::Bounds(all(film, BoundsQuestion::read)?),
            Kind::RayBox => Questions::RayBox(all(film, BoxQuestion::read)?),
            Kind::Tree => Questions::Tree(all(film, TreeQuestion::read)?),
            Kind::TreeSearch => Questions::TreeSearch(all(film, SearchQuestion::read)?),
        })
    }

    /// Their kind.
    pub fn kind(&self) -> Kind {
        match self {
            Questions::ViewingRay(_) => Kind::ViewingRay,
            Questions::Intersect(_) => Kind::Intersect,
            Questions::FirstHit(_) => Kind::FirstHit,
            Questions::Soup(_) => Kind::Soup,
            Questions::Bounds(_) => Kind::Bounds,
            Questions::RayBox(_) => Kind::RayBox,
            Questions::Tree(_) => Kind::Tree,
            Questions::TreeSearch(_) => Kind::TreeSearch,
        }
    }

    /// How many there are.
    pub fn len(&self) -> usize {
        match self {
            Questions::ViewingRay(all) => all.len(),
            Questions::Intersect(all) => all.len(),
            Questions::FirstHit(all) => all.len(),
            Questions::Soup(all) => all.len(),
            Questions::Bounds(all) => all.len(),
            Questions::RayBox(all) => all.len(),
            Questions::Tree(all) => all.len(),
            Questions::TreeSearch(all) => all.len(),
        }
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The questions in this range.
    pub fn part(&self, range: Range<usize>) -> Questions {
        match self {
            Questions::ViewingRay(all) => Questions::ViewingRay(all[range].to_vec()),
            Questions::Intersect(all) => Questions::Intersect(all[range].to_vec()),
            Questions::FirstHit(all) => Questions::FirstHit(all[range].to_vec()),
            Questions::Soup(all) => Questions::Soup(all[range].to_vec()),
            Questions::Bounds(all) => Questions::Bounds(all[range].to_vec()),
            Questions::RayBox(all) => Questions::RayBox(all[range].to_vec()),
            Questions::Tree(all) => Questions::Tree(all[range].to_vec()),
            Questions::TreeSearch(all) => Questions::TreeSearch(all[range].to_vec()),
        }
    }

    /// Adds questions of the same kind. Returns `false`, and adds none, if their kind differs.
    pub fn append(&mut self, more: &Questions) -> bool {
        match (self, more) {
            (Questions::ViewingRay(all), Questions::ViewingRay(more)) => all.extend(more),
            (Questions::Intersect(all), Questions::Intersect(more)) => all.extend_from_slice(more),
            (Questions::FirstHit(all), Questions::FirstHit(more)) => all.extend_from_slice(more),
            (Questions::Soup(all), Questions::Soup(more)) => all.extend_from_slice(more),
            (Questions::Bounds(all), Questions::Bounds(more)) => all.extend_from_slice(more),
            (Questions::RayBox(all), Questions::RayBox(more)) => all.extend_from_slice(more),
            (Questions::Tree(all), Questions::Tree(more)) => all.extend_from_slice(more),
            (Questions::TreeSearch(all), Questions::TreeSearch(more)) => {
                all.extend_from_slice(more);
            }
            _ => return false,
        }
        true
    }

    fn question(&self, index: usize) -> &dyn Question {
        match self {
            Questions::ViewingRay(all) => &all[index],
            Questions::Intersect(all) => &all[index],
            Questions::FirstHit(all) => &all[index],
            Questions::Soup(all) => &all[index],
            Questions::Bounds(all) => &all[index],
            Questions::RayBox(all) => &all[index],
            Questions::Tree(all) => &all[index],
            Questions::TreeSearch(all) => &all[index],
        }
    }

    /// One of the questions, for what says more about it than a submission may know.
    fn for_asker(&self, index: usize) -> &dyn Question {
        super::refuse_in_submission();
        self.question(index)
    }

    /// Asks one of the questions.
    pub(crate) fn answer(
        &self,
        index: usize,
        functions: &[AnswerFn],
    ) -> Result<WireAnswer, Unregistered> {
        self.question(index).answer(index, functions)
    }

    /// Turns what was sent for one of them into an answer; `None` if it answers another kind of
    /// question.
    pub(crate) fn receive(&self, index: usize, sent: &WireAnswer) -> Option<Answer> {
        self.question(index).receive(sent)
    }

    /// The result of a test for one of them; `None` if the question allows no such test.
    pub(crate) fn test(&self, index: usize, test: Test) -> Option<TestResult> {
        match self {
            Questions::TreeSearch(all) => all.get(index)?.test(test),
            _ => None,
        }
    }

    /// The most tests that an answer to one of them may take.
    pub(crate) fn most_tests(&self, index: usize) -> usize {
        match self {
            Questions::TreeSearch(all) => all[index].most_tests(),
            _ => 0,
        }
    }

    /// One of the questions in words, a line for each thing it is about. `part` is the name of
    /// its film.
    pub fn describe(&self, index: usize, part: &str, digits: usize) -> Vec<Fact> {
        self.for_asker(index).describe(part, digits)
    }

    /// An answer to one of them in words.
    pub fn describe_answer(&self, index: usize, answer: &Answer, digits: usize) -> String {
        self.for_asker(index).describe_answer(answer, digits)
    }

    /// The parts of an answer to one of them; `None` if the answer is that nothing is there.
    pub fn parts(&self, index: usize, answer: &Answer) -> Option<Vec<Part>> {
        self.for_asker(index).parts(answer)
    }

    /// Numbers that belong to one of them and its right answer. All questions of a task use the
    /// same names.
    pub fn quantities(&self, index: usize, right: &Answer) -> Vec<Quantity> {
        self.for_asker(index).quantities(right)
    }

    /// Conditions on one of them and on an answer to it, each met or not. All questions of a task
    /// use the same names.
    pub fn conditions(&self, index: usize, answer: &Answer) -> Vec<Condition> {
        self.for_asker(index).conditions(answer)
    }

    /// Plausible wrong answers to one of them, each with a name, if `right` is the right one.
    pub fn others(&self, index: usize, right: &Answer) -> Vec<(&'static str, Answer)> {
        self.for_asker(index).others(right)
    }

    /// The answer that the golden film holds for one of them.
    pub fn expected(&self, golden: &Film, index: usize) -> Answer {
        match self.kind() {
            Kind::ViewingRay => Answer::Ray(golden.ray(index)),
            Kind::Bounds => Answer::Box(golden.bounding_box(index)),
            Kind::Tree => Answer::Tree(golden.tree(index)),
            _ => Answer::Hit(golden.hit(index)),
        }
    }
}
