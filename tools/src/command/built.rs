//! A submission built for a command that lets its code run but judges nothing.

use std::path::PathBuf;

use crate::assignment::Assignment;
use crate::checkout::Checkout;
use crate::cli::Run;
use crate::compile::{Program, Replaced, compile};
use crate::describe::printable_coloured;
use crate::error::{Error, Result};
use crate::progress::Progress;
use crate::sandbox::Sandbox;
use crate::submission::Submission;

/// What runs, and behind which walls.
pub struct Built {
    pub submission: Submission,
    pub sandbox: Sandbox,
    pub program: Program,
}

/// Builds the submission in the folder that was named, or else in the current one, or else
/// the assignment's own.
///
/// # Errors
/// Also if one of its files does not compile: why is on standard error then.
pub fn built(
    checkout: &Checkout,
    assignment: &Assignment,
    named: Option<&PathBuf>,
    run: &Run,
) -> Result<Built> {
    let submission = super::submission(named, assignment, assignment.own_answers())?;
    let sandbox = Sandbox::around(&submission.folder, checkout, run.walls(), &[])?;
    let progress = Progress::new();
    progress.say("building");
    let program = compile(&submission, assignment, checkout, &sandbox)?;
    progress.clear();
    for (task, why) in &program.replaced {
        if let Replaced::DoesNotCompile(diagnostics) = why {
            anstream::eprintln!("{}", printable_coloured(diagnostics.trim_end()));
            return Err(Error::input(
                format!("{task}.rs does not compile"),
                "mend it and try again",
            ));
        }
    }
    Ok(Built {
        submission,
        sandbox,
        program,
    })
}
