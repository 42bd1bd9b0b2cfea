//! How something ended, in a word or two.

use serde::{Deserialize, Serialize};

/// How a submission, a task or a group of questions ended, from the worst to the best. A
/// submission has the worst status among its tasks.
#[derive(Clone, Copy, Debug, Deserialize, Eq, Ord, PartialEq, PartialOrd, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(rename_all = "lowercase")]
pub enum Status {
    /// The grader failed, so there is no mark.
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
    /// The process took more memory than its limit.
    #[serde(rename = "out of memory")]
    OutOfMemory,
    /// The process ended early.
    Killed,
    /// Not every answer came in time.
    #[serde(rename = "timed out")]
    TimedOut,
    /// The student's code panicked.
    Panicked,
    /// The answers were not a film that could be compared.
    Unreadable,
    /// The answer, or one that it calls, is still `todo!`.
    Unanswered,
    /// Every answer was compared with the expected one.
    Graded,
}

impl Status {
    /// All statuses, the worst first.
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

    /// The status in words.
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
