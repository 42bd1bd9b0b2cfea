//! `result.json`: what is stored about one graded submission. All tables and pages of a class are
//! computed from these files and the roster, so that shards can be merged.
//!
//! It is an [`Outcome`] with the additions of grading. `tools/schema/result.schema.json`
//! describes both.

mod summary;

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use super::provenance::Provenance;
use pinhole_course::outcome::{Outcome, SceneOutcome, Status};

pub use self::summary::{PartSummary, RecordSummary, TaskSummary};

/// One graded submission.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Record {
    /// The submission's folder under `submissions`.
    pub id: String,
    /// How the submission ended: the worst status of its tasks and scenes.
    #[serde(rename = "outcome")]
    #[cfg_attr(test, schemars(with = "tests::StatusReference"))]
    pub status: Status,
    /// The meaning of the status, for the student; for `not graded`, the reason.
    pub explanation: String,
    /// Its outcome, as far as students may see it. The points are those of the mark.
    #[serde(flatten)]
    #[cfg_attr(test, schemars(skip))]
    pub got: Outcome,
    /// How the submission's files were read, if something was unusual.
    pub remarks: Vec<String>,
    /// Fresh scenes. They earn nothing, but limit what `scenes` may earn.
    #[cfg_attr(test, schemars(with = "Vec<tests::SceneReference>"))]
    pub fresh_scenes: Vec<SceneOutcome>,
    /// The most that `scenes` may earn, if fresh questions were asked.
    pub most_for_scenes: Option<u32>,
    /// Which tasks the scenes need, if fresh questions were asked.
    #[serde(default)]
    pub needs: SceneNeeds,
    /// By task, a hash of the answer's tokens, without comments, spaces, line breaks and names.
    pub tokens: BTreeMap<String, String>,
    /// What the mark was made from. Equal provenance means an equal mark.
    pub provenance: Provenance,
    /// Where the time went.
    pub timings: Timings,
}

/// Which tasks the scenes need. The points of those tasks limit the points of the scenes.
#[derive(Clone, Debug, Default, Deserialize, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct SceneNeeds {
    /// The tasks that each scene needs, in the order of `scenes`.
    pub scenes: Vec<Vec<String>>,
    /// The tasks that the fresh scenes need together.
    pub fresh: Vec<String>,
}

/// Where the time went, in seconds of the wall clock. No mark depends on it.
#[derive(Clone, Debug, Default, Deserialize, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Timings {
    /// All stages together.
    pub total: f64,
    /// Building the program.
    pub compiling: f64,
    /// Running the program and judging its answers.
    pub asking: f64,
    /// Writing the report.
    pub report: f64,
    /// 1 if an answer exceeded its time limit, or died, while other submissions were graded,
    /// and this submission was therefore graded again, alone.
    pub second_runs: u32,
}

impl Record {
    /// A submission that could not be graded, through no fault of the student's.
    pub fn not_graded(mut self, why: String) -> Record {
        self.status = Status::NotGraded;
        self.explanation = why;
        self.got.points = None;
        self
    }

    /// Whether it has a mark.
    pub fn is_graded(&self) -> bool {
        self.got.points.is_some()
    }

    /// The points of the scenes.
    pub fn scene_points(&self) -> (u32, u32) {
        let scenes = self.got.scenes.iter();
        let earned: u32 = scenes.clone().map(|scene| scene.points).sum();
        let most = self.most_for_scenes.unwrap_or(earned);
        (earned.min(most), scenes.map(|scene| scene.possible).sum())
    }

    /// How each task ended that was not judged, such as "panicked: sphere, plane", and how files
    /// were read.
    pub fn notes(&self) -> String {
        let of = |status: Status| {
            let tasks = self.got.tasks.iter();
            let tasks = tasks.filter(|task| task.status() == status);
            let tasks: Vec<&str> = tasks.map(|task| task.name.as_str()).collect();
            (!tasks.is_empty()).then(|| format!("{}: {}", status.word(), tasks.join(", ")))
        };
        let told = Status::ALL.into_iter();
        let told = told.filter(|status| *status != Status::Graded);
        let told = told.filter_map(of).chain(self.remarks.iter().cloned());
        told.collect::<Vec<_>>().join("; ")
    }
}

/// The meaning of a status, for students.
pub fn explained(status: Status) -> &'static str {
    match status {
        Status::NotGraded => {
            "Grading failed through no fault of yours, so there is no mark. Nothing is \
             lost: your instructor will grade your answers again."
        }
        Status::RefusedFile => {
            "A file was not accepted. An answer is one regular UTF-8 text file of at most 256 \
             KiB; links, devices and archives inside archives do not count."
        }
        Status::MissingFile => {
            "An answer file was not handed in, or was handed in under another name. All other \
             answers were judged; hand in all files of the handout's `src` folder."
        }
        Status::DoesNotCompile => {
            "An answer does not compile, so its stub was judged instead. All other answers were \
             judged. The compiler's message is below; `check` shows the same."
        }
        Status::OutOfMemory => {
            "An answer asked for more memory than it may have, and was stopped. No task \
             needs a collection that grows with every call."
        }
        Status::Killed => {
            "The program ended before it had answered: it exited, crashed, or was stopped because \
             it exceeded a limit."
        }
        Status::TimedOut => {
            "An answer exceeded its time limit twice, the second time with nothing else running. \
             The limit is far above what any right answer needs: look for a loop that does not end."
        }
        Status::Panicked => {
            "An answer panicked. The message and its line are below. The usual causes are an \
             index out of bounds, an `unwrap` of `None`, and an integer that overflows."
        }
        Status::Unreadable => {
            "The program sent back something that is not a valid answer, such as NaN, or an \
             answer to a question that was not asked."
        }
        Status::Unanswered => "An answer is still `todo!`. All others were judged.",
        Status::Graded => "Every answer was compared with the expected one.",
    }
}

#[cfg(test)]
pub mod tests;
