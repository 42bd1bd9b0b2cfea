//! A student's answers for the study: asked behind walls, as every submission is.

use std::fs;
use std::path::{Path, PathBuf};
use std::time::Duration;

use pinhole::ask::Ending;
use pinhole::job::{Answer, Job};
use serde::{Deserialize, Serialize};

use super::{run_quietly, scratch};
use crate::assignment::Assignment;
use crate::checkout::Checkout;
use crate::cli::Study;
use crate::command::built::{Built, built};
use crate::describe::printable;
use crate::error::{Error, Result};
use crate::examine;
use crate::progress::Progress;
use crate::sandbox::Limits;
use crate::table;

/// One part of the study: `Asked` in its package.
#[derive(Deserialize)]
struct Asked {
    part: String,
    job: Job,
}

/// What came of it: `Said` in its package.
#[derive(Serialize)]
struct Said {
    part: String,
    answers: Vec<Option<Answer>>,
    problem: Option<String>,
}

/// A question that panics costs its own answer, but not more than so many in a part:
/// after each, the program starts anew.
const MOST_PANICS: usize = 20;

/// Has everything answered, and says in which file the answers are.
pub fn answers(checkout: &Checkout, arguments: &Study, folder: &Path) -> Result<PathBuf> {
    let assignment = Assignment::around(checkout, folder)?;
    let folder = Some(folder.to_owned());
    let built = built(checkout, &assignment, folder.as_ref(), &arguments.run)?;
    let wall = Duration::from_secs(arguments.run.timeout);

    let progress = Progress::new();
    progress.say("writing questions");
    let parts = questions(checkout)?;
    let mut said = Vec::new();
    for (at, asked) in parts.iter().enumerate() {
        progress.show(&asked.part, at as f64 / parts.len() as f64);
        said.push(built.ask(asked, &assignment, wall)?);
    }
    progress.clear();
    let file = scratch(checkout, "answers")?;
    let bytes = postcard::to_stdvec(&said).map_err(|error| cannot(&file, &error))?;
    fs::write(&file, bytes).map_err(|error| cannot(&file, &error))?;
    Ok(file)
}

/// What the study asks.
fn questions(checkout: &Checkout) -> Result<Vec<Asked>> {
    let file = scratch(checkout, "questions")?;
    run_quietly(checkout, "questions", &file)?;
    let bytes = fs::read(&file).map_err(|error| cannot(&file, &error))?;
    fs::remove_file(&file).map_err(|error| cannot(&file, &error))?;
    postcard::from_bytes(&bytes).map_err(|error| cannot(&file, &error))
}

fn cannot(file: &Path, error: &dyn std::fmt::Display) -> Error {
    Error::environment(
        format!("cannot use {}: {error}", file.display()),
        "make room on the disk, and run this again",
    )
}

impl Built {
    /// One part. Where an answer panics, those after it are asked anew.
    fn ask(&self, asked: &Asked, assignment: &Assignment, wall: Duration) -> Result<Said> {
        let limits = Limits::of_answers(wall);
        let mut said = Said {
            part: asked.part.clone(),
            answers: Vec::new(),
            problem: None,
        };
        let task = asked.part.split(',').next();
        for _ in 0..MOST_PANICS {
            let rest = after(&asked.job, said.answers.len());
            let reply = examine::run(&self.program, &self.sandbox, &limits, &rest, &mut |_| ())?;
            if let Some(outcome) = examine::failure(&reply.ending, assignment, task) {
                let problem = printable(&table::outcome(&outcome));
                said.problem.get_or_insert(problem);
            }
            match (&reply.ending, &rest) {
                (Ending::Panicked(panic), Job::Intersect(_)) if !panic.is_unanswered() => {
                    let done = reply.answers.into_iter().take(panic.index + 1);
                    said.answers.extend(done);
                }
                _ => {
                    said.answers.extend(reply.answers);
                    break;
                }
            }
            if said.answers.len() >= asked.job.len() {
                break;
            }
        }
        said.answers.resize(asked.job.len(), None);
        Ok(said)
    }
}

/// A job without its first questions; a film is cast whole.
fn after(job: &Job, done: usize) -> Job {
    match job {
        Job::Intersect(questions) => Job::Intersect(questions[done..].to_vec()),
        other => other.clone(),
    }
}
