//! What a submission got: every task, group of questions and scene.
//!
//! [`Outcome`] is the only type for this. `check --json` prints it, `grade` keeps it in
//! `result.json`, and the terminal's text, HTML and other graders' formats are made from it.
//! `tools/schema/outcome.schema.json` describes it. An [`Examination`] carries the films beside
//! it, because they are too large for a document.

mod film;
mod status;
mod task;

use std::path::PathBuf;

use pinhole::judge::{Golden, Verdict};
use pinhole::kind::CameraQuestion;
use pinhole::{BoundingBox, Film, NodeBox};
use serde::{Deserialize, Serialize};

use crate::describe::UnansweredPixel;
use crate::diagnosis::Diagnosis;
use crate::diagnosis::measure::Finding;
use crate::submission::flags::Flag;

pub use self::film::{Comparison, FilmOutcome};
pub use self::status::Status;
pub use self::task::{AnswerFile, GroupOutcome, TaskOutcome};

/// The version of the document. Raise it with every change that breaks readers.
pub const SCHEMA: u32 = 2;

/// An outcome and the films it was made from.
#[derive(Debug)]
pub struct Examination {
    /// The points, and everything that earned or lost them.
    pub outcome: Outcome,
    /// What was cast, in the order of the outcome's scenes.
    pub films: Vec<SceneFilm>,
    /// What can be drawn of questions, at most one picture for each group.
    pub pictures: Vec<GroupPicture>,
}

impl Examination {
    /// Answers that may be why a scene fails although they pass their tasks: each task, and what
    /// was measured in its answers. Empty if another answer that the scene needs fails.
    pub fn suspects<'a>(&'a self, film: &'a SceneFilm) -> Vec<(&'a str, &'a Finding)> {
        let tasks = self.outcome.tasks.iter();
        let needed = tasks.filter(|task| film.needs.contains(&task.name));
        if !needed.clone().all(TaskOutcome::passes) {
            return Vec::new();
        }
        let measured = needed.flat_map(|task| {
            let findings = task.measured.iter();
            findings.map(|finding| (task.name.as_str(), finding))
        });
        measured.collect()
    }
}

/// What can be drawn of a group of questions.
#[derive(Debug)]
pub struct GroupPicture {
    /// The task.
    pub task: String,
    /// The group of questions.
    pub group: String,
    /// What is drawn.
    pub shows: Picture,
}

/// An answer beside what is expected, for people.
#[derive(Debug)]
pub enum Picture {
    /// The tests that each question took.
    Tests {
        /// How many are enough, as Mitsuba's film says.
        golden: Film,
        /// What the submission answered, and how many tests it took.
        film: Film,
    },
    /// The worst of a group's rays, where it meets the image plane.
    Ray {
        /// The camera and the pixel.
        question: CameraQuestion,
        /// The expected point: along u and v from the middle, in scene units.
        expected: [f64; 2],
        /// The submission's point.
        got: [f64; 2],
    },
    /// The worst of a group's trees.
    Tree {
        /// The boxes of the primitives.
        primitives: Vec<BoundingBox>,
        /// The upper boxes of a right tree.
        expected: Vec<NodeBox>,
        /// Those of the submission's tree.
        got: Vec<NodeBox>,
    },
}

/// A scene's film and what it was compared with, for pictures.
#[derive(Debug)]
pub struct SceneFilm {
    /// The scene file.
    pub file: PathBuf,
    /// How to name it in `explain` and `render`: by its name, or by its file.
    pub argument: String,
    /// What Mitsuba saw.
    pub golden: Golden,
    /// What the submission cast, if every pixel is there.
    pub film: Option<Film>,
    /// The judge's verdict, if the film could be compared.
    pub verdict: Option<Verdict>,
    /// The submission's rays through its pixels.
    pub rays: OwnRays,
    /// How many tests each pixel took, as the submission counts them, if it does.
    pub tests: Option<Film>,
    /// The tasks whose answers it needs.
    pub needs: Vec<String>,
    /// The pixel without a usable answer, if the film was not judged for that reason.
    pub unanswered: Option<UnansweredPixel>,
}

/// What is known of the rays that a submission sends through the pixels of a scene.
#[derive(Debug, Default)]
pub enum OwnRays {
    /// Nothing is known.
    #[default]
    Unknown,
    /// The task that asks for them passes.
    Right,
    /// The rays that the submission answers.
    Asked(Film),
}

/// Everything the judge can say about one submission.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Outcome {
    /// The version of this format.
    pub schema: u32,
    /// The assignment's title.
    pub assignment: String,
    /// The folder as the user named it. In a class, the name that it was handed in under.
    pub submission: String,
    /// Whether everything that was asked passes.
    pub passes: bool,
    /// Points earned; null if the submission could not be graded, which is not the same as zero.
    pub points: Option<u32>,
    /// The most points that could be earned in what was asked.
    pub possible: u32,
    /// Points that cannot be earned here, for scenes that students do not have.
    pub withheld: u32,
    /// The tasks, in the assignment's order.
    pub tasks: Vec<TaskOutcome>,
    /// The scenes, in the assignment's order.
    pub scenes: Vec<SceneOutcome>,
    /// How an answer to an earlier assignment was used. Absent if no such answer was handed in
    /// again, or if no scene was cast.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub earlier: Option<EarlierOutcome>,
    /// The beginning of what the student's code printed. Empty if anything that was asked is
    /// withheld.
    pub printed: String,
    /// The sandbox that the student's code ran in.
    pub sandbox: String,
    /// Lines that an instructor may want to look at.
    pub flags: Vec<Flag>,
}

/// How an answer to a task of an earlier assignment was used.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct EarlierOutcome {
    /// The task.
    pub task: String,
    /// The earlier assignment.
    pub assignment: String,
    /// What is wrong with this answer, as a clause: "it does not compile". Null if it is right, so that
    /// scenes were cast with it.
    pub problem: Option<String>,
    /// Whether scenes were cast with it even if it is wrong, because other answers don't compile
    /// without it.
    #[serde(default)]
    pub is_needed: bool,
}

/// One scene, cast by all answers together.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct SceneOutcome {
    /// The scene.
    pub name: String,
    /// All its points, or 0.
    pub points: u32,
    /// The points that the scene is worth.
    pub possible: u32,
    /// How its film fared.
    pub outcome: FilmOutcome,
    /// How long the cast took, including the start of the process; null if the scene is withheld,
    /// or was cast together with others.
    pub seconds: Option<f64>,
    /// The beliefs that explain its wrong pixels; null if no known belief does.
    #[serde(with = "crate::diagnosis::or_null")]
    #[cfg_attr(test, schemars(with = "Option<Diagnosis>"))]
    pub diagnosis: Diagnosis,
}

impl Outcome {
    /// An outcome without anything asked yet.
    pub fn new(assignment: &str, submission: String, sandbox: &str) -> Outcome {
        Outcome {
            schema: SCHEMA,
            assignment: assignment.into(),
            submission,
            passes: true,
            points: Some(0),
            possible: 0,
            withheld: 0,
            tasks: Vec::new(),
            scenes: Vec::new(),
            earlier: None,
            printed: String::new(),
            sandbox: sandbox.into(),
            flags: Vec::new(),
        }
    }

    /// Adds up the points of tasks and scenes, after some of them have changed.
    pub fn add_up(&mut self) {
        for task in &mut self.tasks {
            task.add_up();
        }
        let tasks = self.tasks.iter().map(|task| (task.points, task.possible));
        let scenes = self.scenes.iter();
        let (points, possible) = sum(tasks.chain(scenes.map(|it| (it.points, it.possible))));
        (self.points, self.possible) = (Some(points), possible);
        let passes = self.films().all(|(_, _, film)| film.passes());
        self.passes = passes;
    }

    /// Everything that was asked: for questions, task and group; for a scene, its name alone.
    pub fn films(&self) -> impl Iterator<Item = (Option<&str>, &str, &FilmOutcome)> {
        let groups = self.tasks.iter().flat_map(|task| {
            let of_group = |group| film_of_group(&task.name, group);
            task.groups.iter().map(of_group)
        });
        let scenes = self.scenes.iter();
        groups.chain(scenes.map(|scene| (None, scene.name.as_str(), &scene.outcome)))
    }

    /// How it ended: the worst status of its tasks and scenes.
    pub fn status(&self) -> Status {
        let tasks = self.tasks.iter().map(TaskOutcome::status);
        let scenes = self.scenes.iter().map(|scene| scene.outcome.status());
        tasks.chain(scenes).min().unwrap_or(Status::Graded)
    }
}

fn film_of_group<'a>(
    task: &'a str,
    group: &'a GroupOutcome,
) -> (Option<&'a str>, &'a str, &'a FilmOutcome) {
    (Some(task), &group.name, &group.outcome)
}

impl SceneOutcome {
    /// A scene that is worth this many points.
    pub fn new(
        name: String,
        worth: u32,
        outcome: FilmOutcome,
        seconds: Option<f64>,
    ) -> SceneOutcome {
        SceneOutcome {
            name,
            points: outcome.earns(worth),
            possible: worth,
            outcome,
            seconds,
            diagnosis: Diagnosis::default(),
        }
    }
}

/// Sums of points earned and points possible.
fn sum(points: impl Iterator<Item = (u32, u32)>) -> (u32, u32) {
    points.fold((0, 0), |sum, (points, possible)| {
        (sum.0 + points, sum.1 + possible)
    })
}

#[cfg(test)]
mod tests;
