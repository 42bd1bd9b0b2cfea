//! What one answer got: its file, and its groups of questions.

use std::ffi::OsStr;
use std::path::Path;

use pinhole::Fact;
use serde::{Deserialize, Serialize, Serializer};

use super::{FilmOutcome, Status, sum};
use crate::assignment::{GroupPoints, Task};
use crate::compile::Replacement;
use crate::diagnosis::Diagnosis;
use crate::diagnosis::measure::Finding;
use crate::submission::AnswerFileProblem;

/// One answer, judged alone.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct TaskOutcome {
    /// The task.
    pub name: String,
    /// The chapter of the book that teaches it.
    pub chapter: String,
    /// Points earned by its groups.
    pub points: u32,
    /// Points that its groups are worth.
    pub possible: u32,
    /// The state of its file.
    pub file: AnswerFile,
    /// Its groups of questions.
    pub groups: Vec<GroupOutcome>,
    /// The beliefs that explain its wrong answers; null if no known belief does.
    #[serde(with = "crate::diagnosis::or_null")]
    #[cfg_attr(test, schemars(with = "Option<Diagnosis>"))]
    pub diagnosis: Diagnosis,
    /// What is measurably wrong in its answers, even if no belief explains it.
    #[serde(default)]
    pub measured: Vec<Finding>,
    /// The compiler's warnings, if the student's own answer fails. In JSON, they have no colours.
    #[serde(default, serialize_with = "without_colours")]
    pub warnings: String,
}

/// One group of questions, all-or-nothing.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct GroupOutcome {
    /// The group.
    pub name: String,
    /// What the group asks about.
    pub about: String,
    /// All its points, or 0.
    pub points: u32,
    /// The points that the group is worth.
    pub possible: u32,
    /// The outcome of the first film that does not pass, if any.
    pub outcome: FilmOutcome,
    /// The worst question: what was asked, expected and given, or the question at which the code
    /// panicked, ran out of time, or gave a number that is not finite. Empty if no answer is wrong.
    #[cfg_attr(test, schemars(with = "Vec<super::tests::FactSchema>"))]
    pub worst: Vec<Fact>,
    /// Whether it passes the public questions but fails fresh ones.
    pub fails_fresh: bool,
}

/// The state of an answer's file.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(tag = "state", rename_all = "lowercase")]
pub enum AnswerFile {
    /// The answer in the file was judged. In all other states, the stub was judged instead.
    Compiled,
    /// It is not there.
    Missing,
    /// It is not a regular UTF-8 file, or it is too long.
    Refused {
        /// The reason, in words.
        why: String,
    },
    /// The compiler refused it.
    #[serde(rename = "does not compile")]
    DoesNotCompile {
        /// The compiler's messages about the file. In JSON, they have no colours.
        #[serde(serialize_with = "without_colours")]
        compiler: String,
    },
}

impl AnswerFile {
    /// Why the stub was judged instead of the answer, without colours.
    pub fn problem(&self) -> Option<String> {
        match self {
            AnswerFile::Compiled => None,
            AnswerFile::Missing => Some("the answer's file was not handed in".into()),
            AnswerFile::Refused { why } => Some(format!("the answer's file was refused: {why}")),
            AnswerFile::DoesNotCompile { compiler } => {
                Some(anstream::adapter::strip_str(compiler).to_string())
            }
        }
    }
}

impl TaskOutcome {
    /// A task whose groups were judged.
    pub fn new(
        task: &Task,
        replaced: Option<&Replacement>,
        groups: Vec<GroupOutcome>,
        diagnosis: Diagnosis,
        measured: Vec<Finding>,
    ) -> TaskOutcome {
        let mut outcome = TaskOutcome {
            name: task.name.clone(),
            chapter: task.chapter.clone(),
            points: 0,
            possible: 0,
            file: AnswerFile::of(replaced),
            groups,
            diagnosis,
            measured,
            warnings: String::new(),
        };
        outcome.add_up();
        outcome
    }

    /// A task whose answer was replaced by its stub, because it can't be asked.
    pub fn replaced(task: &Task, replaced: &Replacement) -> TaskOutcome {
        let group = |points: &GroupPoints| {
            let (name, about) = (points.group.clone(), points.about.clone());
            GroupOutcome::new(
                name,
                about,
                points.worth,
                FilmOutcome::Unanswered,
                Vec::new(),
            )
        };
        let groups = task.points.iter().map(group).collect();
        TaskOutcome::new(
            task,
            Some(replaced),
            groups,
            Diagnosis::default(),
            Vec::new(),
        )
    }

    pub(super) fn add_up(&mut self) {
        let groups = self.groups.iter();
        (self.points, self.possible) = sum(groups.map(|it| (it.points, it.possible)));
    }

    /// Its groups of questions, without the examples.
    pub fn groups_of_questions(&self) -> impl Iterator<Item = &GroupOutcome> {
        self.groups.iter().filter(|group| !group.is_of_examples())
    }

    /// Whether every group of questions passes.
    pub fn passes(&self) -> bool {
        let mut groups = self.groups_of_questions();
        groups.all(|group| group.outcome.passes())
    }

    /// The line of the answer's file that the compiler's first message names, or at which the
    /// answer panicked, from 1.
    pub fn line(&self) -> Option<usize> {
        if let AnswerFile::DoesNotCompile { compiler } = &self.file {
            let (_, place) = compiler.split_once(&format!("{}.rs:", self.name))?;
            return place
                .split(|c: char| !c.is_ascii_digit())
                .next()?
                .parse()
                .ok();
        }
        self.groups.iter().find_map(|group| match &group.outcome {
            FilmOutcome::Panicked { file, line, .. } => {
                let is_own = Path::new(file).file_stem() == Some(OsStr::new(&self.name));
                // 0 stands for an unknown line.
                (is_own && *line > 0).then_some(*line as usize)
            }
            _ => None,
        })
    }

    /// Whether the answer is still `todo!`.
    pub fn is_unanswered(&self) -> bool {
        let unanswered = |group: &GroupOutcome| group.outcome == FilmOutcome::Unanswered;
        !self.groups.is_empty() && self.groups_of_questions().all(unanswered)
    }

    /// How it ended: the worst status among its groups, unless the file itself could not be
    /// judged.
    pub fn status(&self) -> Status {
        let groups = self.groups.iter().map(|group| group.outcome.status());
        match self.file {
            AnswerFile::Missing => Status::MissingFile,
            AnswerFile::Refused { .. } => Status::RefusedFile,
            AnswerFile::DoesNotCompile { .. } => Status::DoesNotCompile,
            AnswerFile::Compiled => groups.min().unwrap_or(Status::Graded),
        }
    }
}

impl GroupOutcome {
    /// A group that is worth this many points.
    pub fn new(
        name: String,
        about: String,
        worth: u32,
        outcome: FilmOutcome,
        worst: Vec<Fact>,
    ) -> GroupOutcome {
        GroupOutcome {
            name,
            about,
            points: outcome.earns(worth),
            possible: worth,
            outcome,
            worst,
            fails_fresh: false,
        }
    }

    /// Whether it stands for the task's examples. It then has no questions that code was asked.
    pub fn is_of_examples(&self) -> bool {
        matches!(self.outcome, FilmOutcome::Examples { .. })
    }
}

impl AnswerFile {
    /// The state of a file, unless it was replaced by its stub.
    pub fn of(replaced: Option<&Replacement>) -> AnswerFile {
        match replaced {
            None => AnswerFile::Compiled,
            Some(Replacement::Unusable(AnswerFileProblem::Missing)) => AnswerFile::Missing,
            Some(Replacement::Unusable(AnswerFileProblem::Refused(why))) => {
                AnswerFile::Refused { why: why.clone() }
            }
            Some(Replacement::DoesNotCompile(compiler)) => AnswerFile::DoesNotCompile {
                compiler: compiler.clone(),
            },
        }
    }
}

fn without_colours<S: Serializer>(text: &str, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_str(&anstream::adapter::strip_str(text))
}
