//! The kinds of questions a submission can be asked.
//!
//! A task names its kind in `assignment.toml`. A kind is one file of this folder: what a
//! question holds, how it is read from a question film, which of the submission's
//! functions answers it, and how question and answer are put into words.
//!
//! A scene needs every answer at once; a question asks for one answer alone. Each pixel
//! of a question film is a question, and the golden film of the same name holds
//! Mitsuba's answers. All values are exact in 32-bit floats, so that Mitsuba and a
//! submission are asked the same.

mod answer;
mod bounds;
mod cameras;
mod first_hit;
mod intersect;
mod ray_box;
mod soup;
mod tree;
mod tree_search;
mod viewing_ray;

use std::fmt;
use std::ops::Range;
use std::path::Path;

use serde::{Deserialize, Serialize};

use crate::camera::Resolution;
use crate::error::Error;
use crate::fact::Fact;
use crate::film::{Film, Samples};
use crate::part::{Condition, Part, Quantity};
use crate::scene::Scene;
use crate::shape::{Shape, ShapeKind};

pub use answer::{Answer, AnswerFn, Sent, Unregistered};
pub use bounds::BoundsQuestion;
pub use first_hit::ObjectsQuestion;
pub(crate) use first_hit::cast;
pub use intersect::ShapeQuestion;
pub(crate) use intersect::meet;
pub use ray_box::BoxQuestion;
pub use soup::SoupQuestion;
pub use tree::TreeQuestion;
pub(crate) use tree_search::ask_tests_with;
pub use tree_search::{SearchQuestion, Test, TestResult, TestResults};
pub use viewing_ray::CameraQuestion;

/// A kind of question, by its name in `assignment.toml`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Kind {
    /// The ray through a pixel's centre.
    ViewingRay,
    /// A ray and one shape.
    Intersect,
    /// The nearest of several objects along a ray.
    FirstHit,
    /// A ray and a triangle soup, apart from the triangle.
    Soup,
    /// The smallest box around a triangle, or around two boxes.
    Bounds,
    /// A ray and a solid box.
    RayBox,
    /// A tree over triangles.
    Tree,
    /// The first triangle of a tree along a ray, and how many tests it takes to find it.
    TreeSearch,
}

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

/// One question; each kind has a type of its own.
trait Question {
    /// Asks the submission's function for this kind. `index` is the question's place in its
    /// job.
    fn answer(&self, index: usize, functions: &[AnswerFn]) -> Result<Sent, Unregistered>;

    /// The answer that was sent, or `None` if it is one to another kind of question.
    fn receive(&self, sent: Sent) -> Option<Answer> {
        sent.hit()
    }

    /// The question in words, a line for each thing it is about. `part` is the name of
    /// the film it comes from.
    fn describe(&self, part: &str, digits: usize) -> Vec<Fact>;

    /// An answer to it in words.
    fn describe_answer(&self, answer: &Answer, digits: usize) -> String {
        answer.words(digits)
    }

    /// An answer to it part by part; `None` if it says that nothing is there.
    fn parts(&self, answer: &Answer) -> Option<Vec<Part>> {
        match answer {
            Answer::Hit(hit) => hit.map(|hit| hit.parts()),
            Answer::Box(bounds) => Some(bounds.parts()),
            Answer::Ray(_) | Answer::Tree(_) => None,
        }
    }

    /// Numbers that a wrong answer may be off by, if this one is right; the same names for
    /// all questions of a task.
    fn quantities(&self, right: &Answer) -> Vec<Quantity>;

    /// Conditions on it and on an answer to it, each met or not; the same names for all
    /// questions of a task.
    fn conditions(&self, answer: &Answer) -> Vec<Condition>;

    /// Answers that a wrong one may be taken for, each with a name, if this one is right.
    fn others(&self, right: &Answer) -> Vec<(&'static str, Answer)>;
}

impl Kind {
    /// Its name in `assignment.toml`.
    pub fn name(self) -> &'static str {
        match self {
            Kind::ViewingRay => "viewing_ray",
            Kind::Intersect => "intersect",
            Kind::FirstHit => "first_hit",
            Kind::Soup => "soup",
            Kind::Bounds => "bounds",
            Kind::RayBox => "ray_box",
            Kind::Tree => "tree",
            Kind::TreeSearch => "tree_search",
        }
    }

    /// Whether its tasks are about one shape, which they name.
    pub fn takes_shape(self) -> bool {
        self == Kind::Intersect
    }

    /// The kind of task that intersects such a shape alone.
    pub fn of_shape(shape: ShapeKind) -> Kind {
        match shape {
            ShapeKind::Soup => Kind::Soup,
            _ => Kind::Intersect,
        }
    }

    /// Whether a scene cannot be cast without the answer to this kind of task, about this
    /// shape where the kind takes one.
    pub fn is_needed_by(self, shape: Option<ShapeKind>, scene: &Scene) -> bool {
        let objects = scene.objects.iter().map(Shape::kind);
        let mut shapes = objects.flat_map(|object| [&[object], object.parts()].concat());
        match self {
            Kind::ViewingRay | Kind::FirstHit => true,
            Kind::Intersect => shapes.any(|other| Some(other) == shape),
            Kind::Soup | Kind::Bounds | Kind::RayBox | Kind::Tree | Kind::TreeSearch => {
                shapes.any(|other| Kind::of_shape(other) == Kind::Soup)
            }
        }
    }

    /// Whether its answers are rays.
    pub fn gives_rays(self) -> bool {
        self == Kind::ViewingRay
    }

    /// Whether the tests that an answer takes are counted.
    pub fn is_counted(self) -> bool {
        self == Kind::TreeSearch
    }
}

impl fmt::Display for Kind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

impl Questions {
    /// Reads the question film at `path`, and its size. The task and, if it intersects
    /// one, its shape are as `assignment.toml` has them.
    ///
    /// # Errors
    /// If the film cannot be read, lacks a channel of this kind's questions, or holds a
    /// value that makes no question.
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
                format!("this is no question film for `{task}`: {problem}"),
                "make the probes again: cargo pinhole golden render",
            )
        })?;
        Ok((questions, film.resolution()))
    }

    fn from_film(film: &Film, kind: Kind, shape: Option<ShapeKind>) -> Result<Questions, String> {
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

    /// Of which kind they are.
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

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Those in this range.
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

    /// Adds more questions of the same kind; `false`, and none is added, if they are of
    /// another.
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

    /// Asks one of them.
    pub(crate) fn answer(
        &self,
        index: usize,
        functions: &[AnswerFn],
    ) -> Result<Sent, Unregistered> {
        self.question(index).answer(index, functions)
    }

    /// What was sent for one of them as an answer to it, or `None` if it is none.
    pub(crate) fn receive(&self, index: usize, sent: Sent) -> Option<Answer> {
        self.question(index).receive(sent)
    }

    /// The result of a test about one of them, if it can be asked about.
    pub(crate) fn test(&self, index: usize, test: Test) -> Option<TestResult> {
        match self {
            Questions::TreeSearch(all) => all.get(index)?.test(test),
            _ => None,
        }
    }

    /// How many tests an answer to one of them may take at most.
    pub(crate) fn most_tests(&self, index: usize) -> usize {
        match self {
            Questions::TreeSearch(all) => all[index].most_tests(),
            _ => 0,
        }
    }

    /// One of them in words, a line for each thing it is about; `part` is the name of
    /// the film it comes from.
    pub fn describe(&self, index: usize, part: &str, digits: usize) -> Vec<Fact> {
        self.question(index).describe(part, digits)
    }

    /// An answer to one of them in words.
    pub fn describe_answer(&self, index: usize, answer: &Answer, digits: usize) -> String {
        self.question(index).describe_answer(answer, digits)
    }

    /// An answer to one of them part by part; `None` if it says that nothing is there.
    pub fn parts(&self, index: usize, answer: &Answer) -> Option<Vec<Part>> {
        self.question(index).parts(answer)
    }

    /// Numbers that belong to one of them and its right answer, under the same names for all
    /// of a task.
    pub fn quantities(&self, index: usize, right: &Answer) -> Vec<Quantity> {
        self.question(index).quantities(right)
    }

    /// Conditions on one of them and on an answer to it, each met or not, under the same
    /// names for all of a task.
    pub fn conditions(&self, index: usize, answer: &Answer) -> Vec<Condition> {
        self.question(index).conditions(answer)
    }

    /// Answers that a wrong one may be taken for, each with a name, if this one is right.
    pub fn others(&self, index: usize, right: &Answer) -> Vec<(&'static str, Answer)> {
        self.question(index).others(right)
    }

    /// The answer to one of them that its golden film holds.
    pub fn expected(&self, golden: &Film, index: usize) -> Answer {
        match self.kind() {
            Kind::ViewingRay => Answer::Ray(golden.ray(index)),
            Kind::Bounds => Answer::Box(golden.bounding_box(index)),
            Kind::Tree => Answer::Tree(golden.tree(index)),
            _ => Answer::Hit(golden.hit(index)),
        }
    }
}

#[cfg(test)]
mod tests;
