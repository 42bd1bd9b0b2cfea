//! What a submission got: every task, group of questions and scene.
//!
//! [`Outcome`] is the only type for that, from the run to every view: `check --json` prints
//! it, `grade` keeps it in `result.json`, and terminal, HTML and other graders' formats are
//! made from it. `tools/schema/outcome.schema.json` describes it. Films are carried beside
//! it, in an [`Examination`], because they are too large for a document.

use std::path::PathBuf;

use pinhole::judge::{ChannelVerdict, Golden, Refusal, Verdict};
use pinhole::{Fact, Film, Resolution};
use serde::{Deserialize, Serialize, Serializer};

use crate::assignment::{GroupPoints, Task};
use crate::compile::Replaced;
use crate::diagnosis::Diagnosis;
use crate::submission::Unusable;
use crate::submission::flags::Flag;

/// The version of the document. A change that breaks readers counts it up.
pub const SCHEMA: u32 = 2;

/// An outcome and the films it was made from.
#[derive(Debug)]
pub struct Examination {
    /// What it came to.
    pub outcome: Outcome,
    /// What was cast, in the order of the outcome's scenes.
    pub films: Vec<SceneFilm>,
}

/// A scene's film and what it was compared with, for pictures.
#[derive(Debug)]
pub struct SceneFilm {
    /// The scene file.
    pub file: PathBuf,
    /// What `explain` and `render` take for it: its name, or its file.
    pub argument: String,
    /// What Mitsuba saw.
    pub golden: Golden,
    /// What the submission cast, if every pixel came.
    pub film: Option<Film>,
    /// What the judge says of it, if it could be compared.
    pub verdict: Option<Verdict>,
}

/// Everything the judge can say of one submission.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Outcome {
    /// [`SCHEMA`].
    pub schema: u32,
    /// The assignment's title.
    pub assignment: String,
    /// The folder as the user named it; in a class, the name it was handed in under.
    pub submission: String,
    /// Whether everything that was asked passes.
    pub passes: bool,
    /// Points earned; null if it could not be graded, which is no zero.
    pub points: Option<u32>,
    /// Points that what was asked is worth.
    pub possible: u32,
    /// Points that cannot be earned here, for scenes that students do not have.
    pub withheld: u32,
    /// In the assignment's order.
    pub tasks: Vec<TaskOutcome>,
    /// In the assignment's order.
    pub scenes: Vec<SceneOutcome>,
    /// What the student's code printed, cut to its beginning; empty where anything that was
    /// asked is withheld.
    pub printed: String,
    /// What kept the student's code from the rest of the machine.
    pub sandbox: String,
    /// What an instructor may want to look at.
    pub flags: Vec<Flag>,
}

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
    /// What became of its file.
    pub file: AnswerFile,
    /// Its groups of questions.
    pub groups: Vec<GroupOutcome>,
    /// Which beliefs explain its wrong answers; null if nothing known does.
    #[serde(with = "crate::diagnosis::or_null")]
    #[cfg_attr(test, schemars(with = "Option<Diagnosis>"))]
    pub diagnosis: Diagnosis,
}

/// One group of questions, all-or-nothing.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct GroupOutcome {
    /// The group.
    pub name: String,
    /// What it asks.
    pub about: String,
    /// All that it is worth, or 0.
    pub points: u32,
    /// What it is worth.
    pub possible: u32,
    /// How its films fared: the first that does not pass speaks for all.
    pub outcome: FilmOutcome,
    /// The worst question: what was asked, expected and given. Empty where no answer is
    /// wrong.
    #[cfg_attr(test, schemars(with = "Vec<tests::FactSchema>"))]
    pub worst: Vec<Fact>,
    /// Whether it passes the known questions and fails fresh ones.
    pub fails_fresh: bool,
}

/// One scene, cast by all answers together.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct SceneOutcome {
    /// The scene.
    pub name: String,
    /// All that it is worth, or 0.
    pub points: u32,
    /// What it is worth.
    pub possible: u32,
    /// How its film fared.
    pub outcome: FilmOutcome,
    /// How long the cast took, start of the process included; null where the scene is
    /// withheld.
    pub seconds: Option<f64>,
    /// Which beliefs explain its wrong pixels; null if nothing known does.
    #[serde(with = "crate::diagnosis::or_null")]
    #[cfg_attr(test, schemars(with = "Option<Diagnosis>"))]
    pub diagnosis: Diagnosis,
}

/// What became of an answer's file.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(tag = "state", rename_all = "lowercase")]
pub enum AnswerFile {
    /// It was judged. In all other states its stub was.
    Compiled,
    /// It is not there.
    Missing,
    /// It is no regular UTF-8 file of ordinary size.
    Refused {
        /// In words.
        why: String,
    },
    /// The compiler refused it.
    #[serde(rename = "does not compile")]
    DoesNotCompile {
        /// The compiler's own words about it, with their colours; without in documents.
        #[serde(serialize_with = "without_colours")]
        compiler: String,
    },
}

/// How a film fared, or the first film of a group that does not pass.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(tag = "kind", rename_all = "lowercase")]
pub enum FilmOutcome {
    /// It was compared with its golden, and passes or fails.
    Judged(Comparison),
    /// The guards refused it.
    Refused {
        /// In words.
        why: String,
    },
    /// The answer is still `todo!`.
    Unanswered,
    /// It called another answer that is still `todo!`.
    Blocked {
        /// That task.
        by: String,
    },
    /// The student's code panicked.
    Panicked {
        /// What it said.
        message: String,
        /// The source file, as the compiler named it.
        file: String,
        /// Line in that file, from 1; 0 if unknown.
        line: u32,
    },
    /// Not every answer came in time.
    #[serde(rename = "timed out")]
    TimedOut {
        /// The limit, in seconds.
        seconds: f64,
    },
    /// It took more memory than it may.
    #[serde(rename = "out of memory")]
    OutOfMemory {
        /// The limit, in bytes.
        most: u64,
    },
    /// The process ended early.
    Died {
        /// In words.
        how: String,
    },
    /// What it sent was no answer.
    Garbled {
        /// In words.
        why: String,
    },
    /// The student may not see what was asked, and so not all of how it went.
    Withheld {
        /// Whether it earns its points.
        passes: bool,
        /// How it ended.
        ended: Status,
        /// Whether the student may not even read how it ended.
        points_only: bool,
    },
}

/// A film beside its golden.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Comparison {
    /// Whether the film is as good as Mitsuba's.
    pub passes: bool,
    /// Size of film and golden.
    #[cfg_attr(test, schemars(with = "tests::ResolutionSchema"))]
    pub resolution: Resolution,
    /// How many pixels both have.
    pub pixels: usize,
    /// In how many some channel fails.
    pub failing: usize,
    /// How many are exempt by tolerance.
    pub exempt: usize,
    /// Channel by channel; empty where what was asked is withheld.
    #[cfg_attr(test, schemars(with = "Vec<tests::ChannelSchema>"))]
    pub channels: Vec<ChannelVerdict>,
}

/// How a submission, a task or a group of questions ended, in one of eleven words. From the
/// gravest to the best: a submission is called by the gravest of its tasks.
#[derive(Clone, Copy, Debug, Deserialize, Eq, Ord, PartialEq, PartialOrd, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(rename_all = "lowercase")]
pub enum Status {
    /// The grader failed, not the student: there is no mark.
    #[serde(rename = "not graded")]
    NotGraded,
    /// An answer's file was not accepted.
    #[serde(rename = "refused file")]
    RefusedFile,
    /// An answer's file is not there.
    #[serde(rename = "missing file")]
    MissingFile,
    /// An answer does not compile.
    #[serde(rename = "does not compile")]
    DoesNotCompile,
    /// It took more memory than it may.
    #[serde(rename = "out of memory")]
    OutOfMemory,
    /// The process ended early.
    Killed,
    /// Not every answer came in time.
    #[serde(rename = "timed out")]
    TimedOut,
    /// The student's code panicked.
    Panicked,
    /// What came was no film that could be compared.
    Unreadable,
    /// The answer, or one that it calls, is still `todo!`.
    Unanswered,
    /// Every answer was compared with its golden.
    Graded,
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

    /// Everything that was asked: task and group, or nothing and scene.
    pub fn films(&self) -> impl Iterator<Item = (Option<&str>, &str, &FilmOutcome)> {
        let groups = self.tasks.iter().flat_map(|task| {
            let of_group = |group| film_of_group(&task.name, group);
            task.groups.iter().map(of_group)
        });
        let scenes = self.scenes.iter();
        groups.chain(scenes.map(|scene| (None, scene.name.as_str(), &scene.outcome)))
    }

    /// How it ended: the gravest of its tasks and scenes.
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

impl TaskOutcome {
    /// A task whose groups are judged.
    pub fn new(
        task: &Task,
        replaced: Option<&Replaced>,
        groups: Vec<GroupOutcome>,
        diagnosis: Diagnosis,
    ) -> TaskOutcome {
        let mut outcome = TaskOutcome {
            name: task.name.clone(),
            chapter: task.chapter.clone(),
            points: 0,
            possible: 0,
            file: AnswerFile::of(replaced),
            groups,
            diagnosis,
        };
        outcome.add_up();
        outcome
    }

    /// A task whose answer cannot be asked.
    pub fn replaced(task: &Task, replaced: &Replaced) -> TaskOutcome {
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
        TaskOutcome::new(task, Some(replaced), groups, Diagnosis::default())
    }

    fn add_up(&mut self) {
        let groups = self.groups.iter();
        (self.points, self.possible) = sum(groups.map(|it| (it.points, it.possible)));
    }

    /// Whether every group passes.
    pub fn passes(&self) -> bool {
        self.groups.iter().all(|group| group.outcome.passes())
    }

    /// Whether nothing has been attempted yet.
    pub fn is_unanswered(&self) -> bool {
        let unanswered = |group: &GroupOutcome| group.outcome == FilmOutcome::Unanswered;
        !self.groups.is_empty() && self.groups.iter().all(unanswered)
    }

    /// How it ended: the gravest of its groups, unless its file was the matter.
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
    /// A group that is worth so many points.
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
}

impl SceneOutcome {
    /// A scene that is worth so many points.
    pub fn new(name: String, worth: u32, outcome: FilmOutcome, seconds: f64) -> SceneOutcome {
        SceneOutcome {
            name,
            points: outcome.earns(worth),
            possible: worth,
            outcome,
            seconds: Some(seconds),
            diagnosis: Diagnosis::default(),
        }
    }
}

impl AnswerFile {
    /// The state of a file, unless it was replaced by its stub.
    pub fn of(replaced: Option<&Replaced>) -> AnswerFile {
        match replaced {
            None => AnswerFile::Compiled,
            Some(Replaced::Unusable(Unusable::Missing)) => AnswerFile::Missing,
            Some(Replaced::Unusable(Unusable::Refused(why))) => {
                AnswerFile::Refused { why: why.clone() }
            }
            Some(Replaced::DoesNotCompile(compiler)) => AnswerFile::DoesNotCompile {
                compiler: compiler.clone(),
            },
        }
    }
}

impl FilmOutcome {
    /// All points or none.
    fn earns(&self, worth: u32) -> u32 {
        if self.passes() { worth } else { 0 }
    }

    /// Whether it earns its points.
    pub fn passes(&self) -> bool {
        match self {
            FilmOutcome::Judged(comparison) => comparison.passes,
            FilmOutcome::Withheld { passes, .. } => *passes,
            _ => false,
        }
    }

    /// How it ended, in a word.
    pub fn status(&self) -> Status {
        match self {
            FilmOutcome::Judged(_) => Status::Graded,
            FilmOutcome::Refused { .. } | FilmOutcome::Garbled { .. } => Status::Unreadable,
            FilmOutcome::Unanswered | FilmOutcome::Blocked { .. } => Status::Unanswered,
            FilmOutcome::Panicked { .. } => Status::Panicked,
            FilmOutcome::TimedOut { .. } => Status::TimedOut,
            FilmOutcome::OutOfMemory { .. } => Status::OutOfMemory,
            FilmOutcome::Died { .. } => Status::Killed,
            FilmOutcome::Withheld { ended, .. } => *ended,
        }
    }
}

impl From<&Result<Verdict, Refusal>> for FilmOutcome {
    fn from(judged: &Result<Verdict, Refusal>) -> FilmOutcome {
        match judged {
            Ok(verdict) => FilmOutcome::Judged(Comparison {
                passes: verdict.passes(),
                resolution: verdict.resolution,
                pixels: verdict.resolution.pixels(),
                failing: verdict.failing.len(),
                exempt: verdict.exempt,
                channels: verdict.channels.clone(),
            }),
            Err(refusal) => FilmOutcome::Refused {
                why: refusal.to_string(),
            },
        }
    }
}

impl Status {
    /// All of them, the gravest first.
    pub const ALL: [Status; 11] = [
        Status::NotGraded,
        Status::RefusedFile,
        Status::MissingFile,
        Status::DoesNotCompile,
        Status::OutOfMemory,
        Status::Killed,
        Status::TimedOut,
        Status::Panicked,
        Status::Unreadable,
        Status::Unanswered,
        Status::Graded,
    ];

    /// The word.
    pub fn word(self) -> &'static str {
        match self {
            Status::NotGraded => "not graded",
            Status::RefusedFile => "refused file",
            Status::MissingFile => "missing file",
            Status::DoesNotCompile => "does not compile",
            Status::OutOfMemory => "out of memory",
            Status::Killed => "killed",
            Status::TimedOut => "timed out",
            Status::Panicked => "panicked",
            Status::Unreadable => "unreadable",
            Status::Unanswered => "unanswered",
            Status::Graded => "graded",
        }
    }
}

/// Sums of points earned and points possible.
fn sum(points: impl Iterator<Item = (u32, u32)>) -> (u32, u32) {
    points.fold((0, 0), |sum, (points, possible)| {
        (sum.0 + points, sum.1 + possible)
    })
}

fn without_colours<S: Serializer>(text: &str, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_str(&anstream::adapter::strip_str(text))
}

#[cfg(test)]
mod tests;
