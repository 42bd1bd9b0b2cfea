//! Turns a reply into a film and its verdict.

use std::ffi::OsStr;
use std::path::Path;

use pinhole::Film;
use pinhole::ask::{Ending, Reply};
use pinhole::film::TESTS;
use pinhole::job::Panic;
use pinhole::judge::{Refusal, Verdict, judge};
use pinhole::kind::Questions;

use super::Examiner;
use crate::compile::Program;
use crate::describe;
use crate::error::Result;
use crate::goldens::questions::QuestionFilm;
use crate::outcome::{FilmOutcome, Picture};
use crate::timings::timed;

/// The outcome of a film, and the film if it is complete.
pub(super) struct JudgedFilm {
    pub outcome: FilmOutcome,
    pub film: Option<Film>,
    pub verdict: Option<std::result::Result<Verdict, Refusal>>,
}

impl JudgedFilm {
    /// The verdict, if the film could be compared.
    pub fn verdict(&self) -> Option<&Verdict> {
        self.verdict.as_ref()?.as_ref().ok()
    }

    /// What can be drawn of the answers.
    pub fn picture(&self, asked: &QuestionFilm, reply: &Reply) -> Option<Picture> {
        let film = self.film.as_ref()?;
        let (channel, worst) = describe::worst_of(self.verdict()?)?;
        // If this channel fails, all hits are right. If a search's hits were wrong, the number of
        // its tests would mean nothing.
        if channel.name == TESTS {
            return Some(Picture::Tests {
                golden: asked.golden.film().clone(),
                film: film.clone(),
            });
        }
        let index = asked.resolution.index(worst.pixel);
        if let Questions::ViewingRay(questions) = asked.job.questions()? {
            let question = *questions.get(index)?;
            let meets = |film: &Film| question.on_image_plane(&film.ray(index));
            return Some(Picture::Ray {
                question,
                expected: meets(asked.golden.film()),
                got: meets(film),
            });
        }
        let Questions::Tree(questions) = asked.job.questions()? else {
            return None;
        };
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
        let failure = failure(reply, self.program, task);
        if let Some(failure) = failure.filter(|_| !reply.is_whole()) {
            return Ok(JudgedFilm {
                outcome: failure,
                film: None,
                verdict: None,
            });
        }
        let film = reply.film(asked.resolution);
        let verdict = timed("judge", || judge(&asked.golden, &film));
        let outcome = match &verdict {
            // The pixel of a question film means nothing to a student, who sees the question.
            Err(Refusal::NotFinite { channel, .. }) if task.is_some() => FilmOutcome::Refused {
                why: format!("`{channel}` of an answer is NaN or infinite"),
            },
            verdict => FilmOutcome::from(verdict),
        };
        if let Some(second) = self.second_judge {
            timed("oiiotool", || {
                second.confirm(&film, &asked.golden_path, outcome.passes())
            })?;
        }
        Ok(JudgedFilm {
            outcome,
            film: Some(film),
            verdict: Some(verdict),
        })
    }
}

/// What a reply's ending means for the answers; `None` if all is well so far. `task` is the task
/// that was asked alone.
pub fn failure(reply: &Reply, program: &Program, task: Option<&str>) -> Option<FilmOutcome> {
    Some(match &reply.ending {
        Ending::Complete => return None,
        Ending::Panicked(panic) => panicked(panic, program, task),
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
            how: match last_words(&reply.printed) {
                Some(words) => format!("{death}; the last line that it printed is “{words}”"),
                None => death.to_string(),
            },
        },
        Ending::Garbled(why) => FilmOutcome::Garbled { why: why.clone() },
    })
}

/// What an answer printed, without Rust's own message about an overflow of the stack. Every process
/// of such an answer would repeat this message, and they would hide the student's own words.
pub(super) fn without_overflows(printed: &str) -> String {
    let mut kept: Vec<&str> = Vec::new();
    for line in printed.split_inclusive('\n') {
        let words = line.trim_end();
        if words.starts_with("thread '") && words.ends_with("has overflowed its stack") {
            // Rust begins its message with an empty line.
            kept.pop_if(|last| *last == "\n");
        } else if words != "fatal runtime error: stack overflow, aborting" {
            kept.push(line);
        }
    }
    kept.concat()
}

/// At most this many characters of a program's last words are shown.
const MOST_LAST_WORDS: usize = 200;

/// The last line that a program printed. Rust says there why it aborts. But a student's code may
/// print the same words, so we quote them as the code's own and draw no conclusions from them.
fn last_words(printed: &str) -> Option<String> {
    let last = printed
        .lines()
        .map(str::trim)
        .rfind(|line| !line.is_empty());
    last.map(|line| line.chars().take(MOST_LAST_WORDS).collect())
}

/// Code may panic with any message and name any file as the place. So another answer counts as
/// missing only if it is still the stub.
fn panicked(panic: &Panic, program: &Program, task: Option<&str>) -> FilmOutcome {
    let answer = Path::new(&panic.file).file_stem().and_then(OsStr::to_str);
    match answer.filter(|_| panic.is_unanswered()) {
        Some(own) if Some(own) == task => FilmOutcome::Unanswered,
        Some(by) if program.stubs.contains(by) => FilmOutcome::Blocked { by: by.into() },
        _ => FilmOutcome::Panicked {
            message: panic.message.clone(),
            file: panic.file.clone(),
            line: panic.line,
        },
    }
}

#[cfg(test)]
mod tests {
    use super::without_overflows;

    #[test]
    fn an_overflow_of_the_stack_hides_nothing_that_the_student_printed() {
        let overflow = "\nthread '<unknown>' (26959) has overflowed its stack\n\
                        fatal runtime error: stack overflow, aborting\n";
        let printed = format!("t = 1\n\n{overflow}{overflow}t = 2\n");
        assert_eq!(without_overflows(&printed), "t = 1\n\nt = 2\n");
    }
}
