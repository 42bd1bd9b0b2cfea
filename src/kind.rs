//! The kinds of questions a submission can be asked.
//!
//! A task names its kind in `assignment.toml`. A kind is one file of this folder: what a
//! question holds, how it is read from a question film, which of the submission's
//! functions answers it, and how question and answer are put into words.
//!
//! A scene needs every answer at once; a question asks for one answer alone. Each pixel of a
//! question film is a question, and the golden film of the same name holds Mitsuba's answers. All
//! values are exact in 32-bit floats, so that Mitsuba and a submission are asked the same question.

mod answer;
mod bounds;
mod cameras;
mod first_hit;
mod intersect;
mod questions;
mod ray_box;
mod soup;
mod tree;
mod tree_search;
mod viewing_ray;

use std::fmt;
use std::sync::atomic::{AtomicBool, Ordering};

use serde::{Deserialize, Serialize};

use crate::fact::Fact;
use crate::part::{Condition, Part, Quantity};
use crate::scene::Scene;
use crate::shape::{Shape, ShapeKind};

pub use answer::{Answer, AnswerFn, Unregistered, WireAnswer};
pub use bounds::BoundsQuestion;
pub use first_hit::ObjectsQuestion;
pub(crate) use first_hit::cast;
pub use intersect::ShapeQuestion;
pub(crate) use intersect::meet;
pub use questions::Questions;
pub use ray_box::BoxQuestion;
pub use soup::SoupQuestion;
pub use tree::TreeQuestion;
pub(crate) use tree_search::SearchLog;
#[cfg(unix)]
pub(crate) use tree_search::ask_tests_with;
pub use tree_search::{SearchQuestion, Test, TestResult, TestResults};
pub use viewing_ray::CameraQuestion;

/// Whether this process is a submission.
static IS_SUBMISSION: AtomicBool = AtomicBool::new(false);

/// Says that this process is a submission.
pub(crate) fn become_submission() {
    IS_SUBMISSION.store(true, Ordering::Relaxed);
}

/// Panics in a submission. Functions that describe questions and answers call this, because they could
/// give a part of the answer.
fn refuse_in_submission() {
    let is_submission = IS_SUBMISSION.load(Ordering::Relaxed);
    assert!(
        !is_submission,
        "only Pinhole may ask the library for this, and no answer"
    );
}

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
    /// A ray and a triangle soup, judged without the student's triangle.
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

/// One question; each kind has a type of its own.
trait Question {
    /// Asks the submission's function for this kind. `index` is the question's place in its
    /// job.
    fn answer(&self, index: usize, functions: &[AnswerFn]) -> Result<WireAnswer, Unregistered>;

    /// The answer that was sent, or `None` if it answers another kind of question.
    fn receive(&self, sent: &WireAnswer) -> Option<Answer> {
        sent.hit()
    }

    /// The question in words, a line for each thing it is about. `part` is the name of
    /// the film it comes from.
    fn describe(&self, part: &str, digits: usize) -> Vec<Fact>;

    /// An answer to it in words.
    fn describe_answer(&self, answer: &Answer, digits: usize) -> String {
        answer.words(digits)
    }

    /// The parts of an answer to it; `None` if the answer is that nothing is there.
    fn parts(&self, answer: &Answer) -> Option<Vec<Part>> {
        match answer {
            Answer::Hit(hit) => hit.map(|hit| hit.parts()),
            Answer::Box(bounds) => Some(bounds.parts()),
            Answer::Ray(_) | Answer::Tree(_) => None,
        }
    }

    /// Numbers that may explain how far a wrong answer is off. All questions of a task use the
    /// same names.
    fn quantities(&self, right: &Answer) -> Vec<Quantity>;

    /// Conditions on it and on an answer to it, each met or not. All questions of a task use the
    /// same names.
    fn conditions(&self, answer: &Answer) -> Vec<Condition>;

    /// Plausible wrong answers, each with a name, if `right` is the right one.
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

    /// Whether casting a scene needs the answer to a task of this kind, about this shape if the
    /// kind is about one.
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

    /// Whether each question has only one right answer.
    pub fn has_one_answer(self) -> bool {
        self != Kind::Tree
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

#[cfg(test)]
mod tests;
