//! How a submission, a task or a group of questions ended, in one of eleven words, and
//! what each means for the student.

use serde::{Deserialize, Serialize};

use pinhole_course::compile::Replaced;
use pinhole_course::examination::{Outcome, TaskResult};
use pinhole_course::submission::Unusable;

/// From the gravest to the best: a submission is called by the gravest of its tasks.
#[derive(Clone, Copy, Debug, Deserialize, Eq, Ord, PartialEq, PartialOrd, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Kind {
    /// The grader failed, not the student: there is no mark.
    #[serde(rename = "not graded")]
    NotGraded,
    #[serde(rename = "refused file")]
    RefusedFile,
    #[serde(rename = "missing file")]
    MissingFile,
    #[serde(rename = "does not compile")]
    DoesNotCompile,
    #[serde(rename = "out of memory")]
    OutOfMemory,
    Killed,
    #[serde(rename = "timed out")]
    TimedOut,
    Panicked,
    /// What came was no film that could be compared.
    Unreadable,
    Unanswered,
    /// Every answer was compared with its golden.
    Graded,
}

impl Kind {
    /// All of them, the gravest first.
    pub const ALL: [Kind; 11] = [
        Kind::NotGraded,
        Kind::RefusedFile,
        Kind::MissingFile,
        Kind::DoesNotCompile,
        Kind::OutOfMemory,
        Kind::Killed,
        Kind::TimedOut,
        Kind::Panicked,
        Kind::Unreadable,
        Kind::Unanswered,
        Kind::Graded,
    ];

    /// The word.
    pub fn word(self) -> &'static str {
        match self {
            Kind::NotGraded => "not graded",
            Kind::RefusedFile => "refused file",
            Kind::MissingFile => "missing file",
            Kind::DoesNotCompile => "does not compile",
            Kind::OutOfMemory => "out of memory",
            Kind::Killed => "killed",
            Kind::TimedOut => "timed out",
            Kind::Panicked => "panicked",
            Kind::Unreadable => "unreadable",
            Kind::Unanswered => "unanswered",
            Kind::Graded => "graded",
        }
    }

    /// What it means, for the student who reads it.
    pub fn explained(self) -> &'static str {
        match self {
            Kind::NotGraded => {
                "Grading failed for a reason that is not yours, so there is no mark. Nothing is \
                 lost: your instructor grades it again."
            }
            Kind::RefusedFile => {
                "A file was not accepted. An answer is one regular UTF-8 text file of at most 256 \
                 KiB; links, devices and archives inside archives do not count."
            }
            Kind::MissingFile => {
                "An answer file was not handed in, or not under its name. All other answers were \
                 judged; hand in all files of the handout's `src` folder."
            }
            Kind::DoesNotCompile => {
                "An answer does not compile, so its stub stood in for it and all others were \
                 judged. The compiler's words are below; `check` shows the same."
            }
            Kind::OutOfMemory => {
                "An answer asked for more memory than it may have, and was stopped. It does not \
                 need a collection that grows with every call."
            }
            Kind::Killed => {
                "The program ended before it had answered: it left by itself, crashed, or was \
                 stopped for leaving its bounds."
            }
            Kind::TimedOut => {
                "An answer came too late, twice, the second time with the machine to itself. The \
                 limit is far above what any right answer needs: look for a loop that does not end."
            }
            Kind::Panicked => {
                "An answer panicked. The message and its line are below; the usual ones are an \
                 index out of bounds, an `unwrap` of nothing, and an integer that overflows."
            }
            Kind::Unreadable => {
                "What the program sent back was no answer: not finite, say, or not what was asked."
            }
            Kind::Unanswered => "An answer is still `todo!`. All others were judged.",
            Kind::Graded => "Every answer was compared with its golden.",
        }
    }

    /// How one film ended.
    pub fn of(outcome: &Outcome) -> Kind {
        match outcome {
            Outcome::Judged(_) => Kind::Graded,
            Outcome::Refused(_) | Outcome::Garbled(_) => Kind::Unreadable,
            Outcome::Unanswered | Outcome::BlockedBy(_) => Kind::Unanswered,
            Outcome::Panicked(_) => Kind::Panicked,
            Outcome::TimedOut { .. } => Kind::TimedOut,
            Outcome::OutOfMemory { .. } => Kind::OutOfMemory,
            Outcome::Died(_) => Kind::Killed,
        }
    }

    /// How a task ended: the gravest of its groups, unless its file was the matter.
    pub fn of_task(task: &TaskResult) -> Kind {
        match &task.replaced {
            Some(Replaced::Unusable(Unusable::Missing)) => Kind::MissingFile,
            Some(Replaced::Unusable(Unusable::Refused(_))) => Kind::RefusedFile,
            Some(Replaced::DoesNotCompile(_)) => Kind::DoesNotCompile,
            None => {
                let kinds = task.groups.iter().map(|group| Kind::of(&group.outcome));
                kinds.min().unwrap_or(Kind::Graded)
            }
        }
    }
}
