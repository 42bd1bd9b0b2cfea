//! What came of a submission: every task, group and scene, as data.
//!
//! Tables, reports and JSON are views of this.

use std::path::PathBuf;

use pinhole::Film;
use pinhole::job::Panic;
use pinhole::judge::{Golden, Refusal, Verdict};

use crate::assignment::Task;
use crate::compile::Replaced;
use crate::diagnosis::Diagnosis;

/// Everything the judge can say of one submission.
#[derive(Debug)]
pub struct Examination {
    /// The folder as the user named it.
    pub submission: String,
    /// The assignment's title.
    pub title: String,
    /// In the assignment's order.
    pub tasks: Vec<TaskResult>,
    /// In the assignment's order.
    pub scenes: Vec<SceneResult>,
    /// Points that cannot be earned here, for scenes that students do not have.
    pub withheld: u32,
    /// What the student's code printed, cut to its beginning.
    pub printed: String,
}

/// One answer, judged alone.
#[derive(Debug)]
pub struct TaskResult {
    /// The task.
    pub name: String,
    /// The chapter of the book that teaches it.
    pub chapter: String,
    /// Why its stub was judged instead, if so.
    pub replaced: Option<Replaced>,
    /// Its groups of questions.
    pub groups: Vec<GroupResult>,
    /// Which beliefs explain its wrong answers.
    pub diagnosis: Diagnosis,
}

/// One group of questions, all-or-nothing.
#[derive(Debug)]
pub struct GroupResult {
    /// The group.
    pub name: String,
    /// What it is worth.
    pub worth: u32,
    /// What it asks, in words.
    pub about: String,
    /// What came.
    pub outcome: Outcome,
    /// The worst question in words, where some answer is wrong.
    pub worst: Option<String>,
}

/// One scene, cast by all answers together.
#[derive(Debug)]
pub struct SceneResult {
    /// The scene.
    pub name: String,
    /// What `explain` and `render` take for it: its name, or its file.
    pub argument: String,
    /// What it is worth.
    pub worth: u32,
    /// What came.
    pub outcome: Outcome,
    /// How long the cast took, start of the process included.
    pub seconds: f64,
    /// The scene file.
    pub file: PathBuf,
    /// What Mitsuba saw.
    pub golden: Golden,
    /// What came, if every pixel did.
    pub film: Option<Film>,
    /// Which beliefs explain its wrong pixels.
    pub diagnosis: Diagnosis,
}

/// How a film fared.
#[derive(Clone, Debug, PartialEq)]
pub enum Outcome {
    /// It was compared with its golden, and passes or fails.
    Judged(Verdict),
    /// The guards refused it.
    Refused(Refusal),
    /// The answer is still `todo!`.
    Unanswered,
    /// It called another answer that is still `todo!`: that task.
    BlockedBy(String),
    /// The student's code panicked.
    Panicked(Panic),
    /// Not every answer came in time.
    TimedOut {
        /// The limit, in seconds.
        seconds: f64,
    },
    /// It took more memory than it may.
    OutOfMemory {
        /// The limit, in bytes.
        most: u64,
    },
    /// The process ended early: how.
    Died(String),
    /// What it sent was no answer: why.
    Garbled(String),
}

impl Outcome {
    /// All points or none.
    pub fn earns(&self, worth: u32) -> u32 {
        if self.passes() { worth } else { 0 }
    }

    /// Whether it earns its points.
    pub fn passes(&self) -> bool {
        matches!(self, Outcome::Judged(verdict) if verdict.passes())
    }
}

impl TaskResult {
    /// A task whose answer cannot be asked.
    pub fn replaced(task: &Task, replaced: Replaced) -> TaskResult {
        let groups = task.points.iter().map(|points| GroupResult {
            name: points.group.clone(),
            worth: points.worth,
            about: points.about.clone(),
            outcome: Outcome::Unanswered,
            worst: None,
        });
        TaskResult {
            name: task.name.clone(),
            chapter: task.chapter.clone(),
            replaced: Some(replaced),
            groups: groups.collect(),
            diagnosis: Diagnosis::default(),
        }
    }

    /// Points earned and points possible.
    pub fn points(&self) -> (u32, u32) {
        points(
            self.groups
                .iter()
                .map(|group| (&group.outcome, group.worth)),
        )
    }

    /// Whether every group passes.
    pub fn passes(&self) -> bool {
        self.groups.iter().all(|group| group.outcome.passes())
    }

    /// Whether nothing has been attempted yet.
    pub fn is_unanswered(&self) -> bool {
        let unanswered = |group: &GroupResult| group.outcome == Outcome::Unanswered;
        !self.groups.is_empty() && self.groups.iter().all(unanswered)
    }
}

impl Examination {
    /// Points earned and points possible.
    pub fn points(&self) -> (u32, u32) {
        let groups = self.tasks.iter().flat_map(|task| &task.groups);
        let groups = groups.map(|group| (&group.outcome, group.worth));
        points(
            groups.chain(
                self.scenes
                    .iter()
                    .map(|scene| (&scene.outcome, scene.worth)),
            ),
        )
    }

    /// That there is more to earn than can be seen here, if there is.
    pub fn withheld_in_words(&self) -> Option<String> {
        let (_, possible) = self.points();
        let all = possible + self.withheld;
        let words = "can be seen here; the rest is for scenes that come with grading";
        (self.withheld > 0).then(|| format!("{possible} of {all} points {words}"))
    }

    /// Whether everything that was asked passes.
    pub fn passes(&self) -> bool {
        let groups = self
            .tasks
            .iter()
            .flat_map(|task| &task.groups)
            .map(|group| &group.outcome);
        groups
            .chain(self.scenes.iter().map(|scene| &scene.outcome))
            .all(Outcome::passes)
    }
}

fn points<'a>(outcomes: impl Iterator<Item = (&'a Outcome, u32)>) -> (u32, u32) {
    outcomes.fold((0, 0), |(earned, possible), (outcome, worth)| {
        (earned + outcome.earns(worth), possible + worth)
    })
}
