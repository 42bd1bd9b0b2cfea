//! How a film compares with its golden, or why the submission made none.

use pinhole::Resolution;
use pinhole::judge::{ChannelVerdict, Refusal, Verdict};
use serde::{Deserialize, Serialize};

use super::Status;

/// The outcome of a film, or of the first film of a group that does not pass.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(tag = "kind", rename_all = "lowercase")]
pub enum FilmOutcome {
    /// The film was compared with its golden, and passes or fails.
    Judged(Comparison),
    /// The film can't be compared with its golden.
    Refused {
        /// The reason, in words.
        why: String,
    },
    /// The answer is still `todo!`.
    Unanswered,
    /// The film needs another answer, which is still `todo!` or never ends.
    Blocked {
        /// The task of that answer.
        by: String,
    },
    /// The student's code panicked.
    Panicked {
        /// The panic's message.
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
        /// Whether that is the limit of the whole submission.
        #[serde(default)]
        whole: bool,
    },
    /// The process took more memory than its limit.
    #[serde(rename = "out of memory")]
    OutOfMemory {
        /// The limit, in bytes.
        most: u64,
    },
    /// The process ended early.
    Died {
        /// How it ended, in words.
        how: String,
    },
    /// The process sent something that is not an answer.
    Garbled {
        /// What was wrong, in words.
        why: String,
    },
    /// Examples that the student has worked out were judged. No code was asked.
    Examples {
        /// Whether they earn their points.
        passes: bool,
        /// The verdict, in words.
        says: String,
    },
    /// The student may not see what was asked, so the details are withheld.
    Withheld {
        /// Whether it earns its points.
        passes: bool,
        /// How it ended.
        ended: Status,
        /// Whether the student sees only the points, and not how it ended.
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
    #[cfg_attr(test, schemars(with = "super::tests::ResolutionSchema"))]
    pub resolution: Resolution,
    /// How many pixels the film and its golden have.
    pub pixels: usize,
    /// In how many pixels some channel fails.
    pub failing: usize,
    /// How many pixels are exempt.
    pub exempt: usize,
    /// The verdict on each channel. Empty if what was asked is withheld.
    #[cfg_attr(test, schemars(with = "Vec<super::tests::ChannelSchema>"))]
    pub channels: Vec<ChannelVerdict>,
}

impl FilmOutcome {
    /// All points or none.
    pub(super) fn earns(&self, worth: u32) -> u32 {
        if self.passes() { worth } else { 0 }
    }

    /// Whether it earns its points.
    pub fn passes(&self) -> bool {
        match self {
            FilmOutcome::Judged(comparison) => comparison.passes,
            FilmOutcome::Examples { passes, .. } | FilmOutcome::Withheld { passes, .. } => *passes,
            _ => false,
        }
    }

    /// How it ended, in a word.
    pub fn status(&self) -> Status {
        match self {
            FilmOutcome::Judged(_) | FilmOutcome::Examples { .. } => Status::Graded,
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
