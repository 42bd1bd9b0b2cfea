//! Turns a reply into a film and its verdict.

use std::path::Path;

use pinhole::Film;
use pinhole::ask::{Ending, Reply};
use pinhole::film::TESTS;
use pinhole::job::Panic;
use pinhole::judge::{Verdict, judge};
use pinhole::kind::Questions;

use super::Examiner;
use crate::assignment::Assignment;
use crate::describe;
use crate::error::Result;
use crate::goldens::questions::QuestionFilm;
use crate::outcome::{FilmOutcome, Picture};
use crate::timings::timed;

/// The outcome of a film, and the film if it is complete.
pub(super) struct JudgedFilm {
    pub outcome: FilmOutcome,
    pub film: Option<Film>,
    pub verdict: Option<Verdict>,
}

impl JudgedFilm {
    /// What can be drawn of the answers.
    pub fn picture(&self, asked: &QuestionFilm, reply: &Reply) -> Option<Picture> {
        let film = self.film.as_ref()?;
        let (channel, worst) = describe::worst_of(self.verdict.as_ref()?)?;
        // Here, all hits are right. The tests of a search with wrong hits would mean nothing.
        if channel.name == TESTS {
            return Some(Picture::Tests {
                golden: asked.golden.film().clone(),
                film: film.clone(),
            });
        }
        let Questions::Tree(questions) = asked.job.questions()? else {
            return None;
        };
        let index = asked.resolution.index(worst.pixel);
        let question = questions.get(index)?;
        Some(Picture::Tree {
            primitives: question.boxes.clone(),
            expected: question.outline(&question.example),
            got: reply.outlines.get(index)?.clone(),
        })
    }
}

impl Examiner<'_> {
    /// The outcome of a reply's film; `task` if one answer was asked alone.
    pub(super) fn judge(
        &self,
        reply: &Reply,
        asked: &QuestionFilm,
        task: Option<&str>,
    ) -> Result<JudgedFilm> {
        let failure = failure(&reply.ending, self.assignment, task);
        if let Some(failure) = failure.filter(|_| !reply.is_whole()) {
            return Ok(JudgedFilm {
                outcome: failure,
                film: None,
                verdict: None,
            });
        }
        let film = reply.film(asked.resolution);
        let verdict = timed("judge", || judge(&asked.golden, &film));
        let outcome = FilmOutcome::from(&verdict);
        if let Some(second) = self.second_judge {
            timed("oiiotool", || {
                second.confirm(&film, &asked.golden_path, outcome.passes())
            })?;
        }
        Ok(JudgedFilm {
            outcome,
            film: Some(film),
            verdict: verdict.ok(),
        })
    }
}

/// What an ending means for the answers; `None` if all is well so far.
pub fn failure(
    ending: &Ending,
    assignment: &Assignment,
    task: Option<&str>,
) -> Option<FilmOutcome> {
    Some(match ending {
        Ending::Complete => return None,
        Ending::Panicked(panic) if panic.is_unanswered() => match task_of(panic, assignment) {
            Some(other) if Some(other) != task => FilmOutcome::Blocked { by: other.into() },
            _ => FilmOutcome::Unanswered,
        },
        Ending::Panicked(panic) => FilmOutcome::Panicked {
            message: panic.message.clone(),
            file: panic.file.clone(),
            line: panic.line,
        },
        Ending::Unregistered(missing) => FilmOutcome::Died {
            how: missing.to_string(),
        },
        Ending::TimedOut(limit) => FilmOutcome::TimedOut {
            seconds: limit.as_secs_f64(),
            whole: false,
        },
        Ending::OutOfTime(whole) => FilmOutcome::TimedOut {
            seconds: whole.as_secs_f64(),
            whole: true,
        },
        Ending::OutOfMemory(most) => FilmOutcome::OutOfMemory { most: *most },
        Ending::Died(death) => FilmOutcome::Died {
            how: death.to_string(),
        },
        Ending::Garbled(why) => FilmOutcome::Garbled { why: why.clone() },
    })
}

/// The task in whose file a panic happened.
fn task_of<'a>(panic: &Panic, assignment: &'a Assignment) -> Option<&'a str> {
    let stem = Path::new(&panic.file).file_stem()?.to_str()?;
    assignment.task(stem).map(|task| task.name.as_str())
}
