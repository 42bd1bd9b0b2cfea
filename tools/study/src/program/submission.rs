//! A student's answers for the study: asked behind walls, as every submission is.

use std::path::Path;
use std::time::Duration;

use pinhole::ask::Ending;
use pinhole::job::Job;
use pinhole_course::assignment::Assignment;
use pinhole_course::checkout::Checkout;
use pinhole_course::compile::Whole;
use pinhole_course::error::Result;
use pinhole_course::examine;
use pinhole_course::progress::Progress;
use pinhole_course::sandbox::Limits;
use pinhole_report::escape::printable;
use pinhole_report::terminal;
use pinhole_study::asked::asked;
use pinhole_study::run::Extent;
use pinhole_study::theirs::{Asked, Said, Theirs};

use crate::cli::Study;

/// A question that panics costs its own answer, but not more than so many in a part:
/// after each, the program starts anew.
const MOST_PANICS: usize = 20;

/// Has everything answered.
pub fn answers(checkout: &Checkout, arguments: &Study, folder: &Path) -> Result<Theirs> {
    let assignment = arguments.assignment.find(checkout, Some(folder))?;
    let whole = Whole::build(checkout, &assignment, Some(folder), &arguments.run)?;
    let progress = Progress::new();
    progress.say("writing questions");
    let parts = asked(Extent::QUICK.questions, arguments.seed)?;
    let mut said = Vec::new();
    for (at, asked) in parts.iter().enumerate() {
        progress.show(&asked.part, at as f64 / parts.len() as f64);
        said.push(ask(&whole, asked, &assignment, arguments.run.wall())?);
    }
    progress.clear();
    Ok(Theirs::new(said))
}

/// One part. Where an answer panics, those after it are asked anew.
fn ask(whole: &Whole, asked: &Asked, assignment: &Assignment, wall: Duration) -> Result<Said> {
    let limits = Limits::of_answers(wall);
    let mut said = Said {
        part: asked.part.clone(),
        answers: Vec::new(),
        problem: None,
    };
    let task = asked.part.split(',').next();
    for _ in 0..MOST_PANICS {
        let rest = after(&asked.job, said.answers.len());
        let reply = examine::run(&whole.program, &whole.sandbox, &limits, &rest, &mut |_| ())?;
        if let Some(outcome) = examine::failure(&reply.ending, assignment, task) {
            let problem = printable(&terminal::outcome(&outcome));
            said.problem.get_or_insert(problem);
        }
        match (&reply.ending, &rest) {
            (Ending::Panicked(panic), Job::Ask(_)) if !panic.is_unanswered() => {
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

/// A job without its first questions; a film is cast whole.
fn after(job: &Job, done: usize) -> Job {
    match job {
        Job::Ask(questions) => Job::Ask(questions.part(done..questions.len())),
        other => other.clone(),
    }
}
