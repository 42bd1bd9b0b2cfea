//! The films of known mistakes: their answers, laid over the reference's, are asked a film's
//! questions.

use std::path::Path;
use std::time::Duration;

use pinhole::Film;
use pinhole::ask::Reply;

use crate::assignment::Assignment;
use crate::checkout::Checkout;
use crate::compile::{Program, compile};
use crate::error::Result;
use crate::examine;
use crate::goldens::questions::QuestionFilm;
use crate::overlay;
use crate::sandbox::{Limits, Sandbox};

/// How long a program may take for a film.
const TIME_LIMIT: Duration = Duration::from_secs(60);

/// The program of the answers in a folder. The reference's answers take the place of missing ones.
pub fn build(folder: &Path, assignment: &Assignment, checkout: &Checkout) -> Result<Program> {
    let submission = overlay::reference(assignment)?.overlaid(folder)?;
    compile(&submission, assignment, checkout, &Sandbox::Trusted)
}

/// A program's reply to a film's questions.
pub fn ask(program: &Program, film: &QuestionFilm) -> Result<Reply> {
    let limits = Limits::of_answers(TIME_LIMIT);
    examine::run(program, &Sandbox::Trusted, &limits, &film.job, &mut |_| {})
}

/// The film of a mistake; `None` if it panics.
pub fn cast(program: &Program, film: &QuestionFilm) -> Result<Option<Film>> {
    let reply = ask(program, film)?;
    let complete = reply.answers.iter().all(Option::is_some);
    Ok(complete.then(|| reply.film(film.resolution)))
}
