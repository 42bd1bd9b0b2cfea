//! `result.json`: what is kept of one graded submission. Everything said of a class is
//! computed from these and the roster, so that shards can be merged.
//!
//! `tools/schema/result.schema.json` describes it; a change that breaks readers counts
//! [`SCHEMA`] up.

use serde::{Deserialize, Serialize};

use super::kind::Kind;
use super::provenance::Provenance;

/// The version of the schema.
pub const SCHEMA: u32 = 1;

/// One graded submission.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub struct Record {
    pub schema: u32,
    /// Its folder under `submissions`.
    pub id: String,
    /// The folder's or archive's name as it was handed in.
    pub name: String,
    pub assignment: String,
    pub outcome: Kind,
    /// What that means, for the student; for `not graded`, why.
    pub explanation: String,
    /// None if it was not graded.
    pub points: Option<u32>,
    pub possible: u32,
    pub tasks: Vec<TaskRecord>,
    pub scenes: Vec<SceneRecord>,
    /// Scenes nobody has seen: they earn nothing, but bound what `scenes` may earn.
    pub fresh_scenes: Vec<SceneRecord>,
    /// The most that scenes may earn, if fresh questions were asked.
    pub most_for_scenes: Option<u32>,
    pub flags: Vec<FlagRecord>,
    pub provenance: Provenance,
    pub timings: Timings,
    /// What the student's code printed; empty where anything withheld was asked.
    pub printed: String,
}

/// One answer.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub struct TaskRecord {
    pub name: String,
    pub points: u32,
    pub possible: u32,
    pub outcome: Kind,
    /// In words: the same as in the report.
    pub said: String,
    /// The compiler's words, if it does not compile.
    pub compiler: Option<String>,
    pub groups: Vec<GroupRecord>,
    pub diagnosis: Vec<BeliefRecord>,
    /// Hash of the answer's tokens: without comments, spaces and line breaks.
    pub tokens: Option<String>,
}

/// One all-or-nothing group of questions.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub struct GroupRecord {
    pub name: String,
    pub about: String,
    pub points: u32,
    pub possible: u32,
    pub outcome: Kind,
    pub said: String,
    /// The worst question in words, if it may be shown.
    pub worst: Option<String>,
    /// Whether it passes the known questions and fails fresh ones.
    pub fails_fresh: bool,
}

/// One scene.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub struct SceneRecord {
    pub name: String,
    pub points: u32,
    pub possible: u32,
    pub outcome: Kind,
    pub said: String,
    pub diagnosis: Vec<BeliefRecord>,
}

/// A belief that explains what is wrong.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub struct BeliefRecord {
    pub mistake: String,
    pub belief: String,
    /// The share of what is wrong that it explains, 0 to 1.
    pub explained: f64,
    /// Whether others explain as much, so that only one of them is held.
    pub one_of: bool,
    pub look: String,
}

/// Something an instructor may want to read; it costs nothing.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub struct FlagRecord {
    pub task: String,
    pub line: usize,
    pub what: String,
}

/// Where the time went, in seconds of the wall clock. No mark depends on it.
#[derive(Clone, Debug, Default, Deserialize, PartialEq, Serialize)]
pub struct Timings {
    pub total: f64,
    pub compiling: f64,
    pub asking: f64,
    pub report: f64,
    /// 1 if an answer came too late beside others, so that all was graded again, alone.
    pub second_runs: u32,
}

impl Record {
    /// A submission that could not be graded, through no fault of the student's.
    pub fn not_graded(mut self, why: String) -> Record {
        self.outcome = Kind::NotGraded;
        self.explanation = why;
        self.points = None;
        self
    }

    /// Whether it has a mark.
    pub fn is_graded(&self) -> bool {
        self.points.is_some()
    }

    /// What the scenes earn.
    pub fn scene_points(&self) -> (u32, u32) {
        let earned: u32 = self.scenes.iter().map(|scene| scene.points).sum();
        let possible = self.scenes.iter().map(|scene| scene.possible).sum();
        (
            self.most_for_scenes.map_or(earned, |most| earned.min(most)),
            possible,
        )
    }

    /// Which tasks ended in which way, other than judged: "panicked: sphere, plane".
    pub fn notes(&self) -> String {
        let of = |kind: Kind| {
            let tasks = self.tasks.iter().filter(|task| task.outcome == kind);
            let tasks: Vec<&str> = tasks.map(|task| task.name.as_str()).collect();
            (!tasks.is_empty()).then(|| format!("{}: {}", kind.word(), tasks.join(", ")))
        };
        let told = Kind::ALL.into_iter().filter(|kind| *kind != Kind::Graded);
        told.filter_map(of).collect::<Vec<_>>().join("; ")
    }
}
