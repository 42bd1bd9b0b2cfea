//! Compiles a submission for commands that run its code but don't judge it. Every file must
//! compile.

use std::path::Path;

use super::{Program, Replacement, compile};
use crate::assignment::Assignment;
use crate::checkout::Checkout;
use crate::error::{Error, Result};
use crate::progress::Progress;
use crate::run_options::RunOptions;
use crate::sandbox::Sandbox;
use crate::submission::Submission;

/// A submission that compiles as a whole.
pub struct CompiledSubmission {
    /// The answers.
    pub submission: Submission,
    /// The sandbox that the program runs in.
    pub sandbox: Sandbox,
    /// The compiled answers.
    pub program: Program,
}

impl CompiledSubmission {
    /// Builds the submission in the folder that was named, or else in the current one, or
    /// else the handout.
    ///
    /// # Errors
    /// If it can't be found or built, or one of its files does not compile.
    pub fn build(
        checkout: &Checkout,
        assignment: &Assignment,
        named: Option<&Path>,
        options: &RunOptions,
    ) -> Result<CompiledSubmission> {
        let submission = Submission::named_or(named, assignment)?;
        let choice = options.sandbox.choice();
        let sandbox = Sandbox::around(&submission.read_from, checkout, choice, &[])?;
        let progress = Progress::new();
        progress.say("building");
        let program = compile(&submission, assignment, checkout, &sandbox)?;
        progress.clear();
        for (task, why) in &program.replaced {
            if let Replacement::DoesNotCompile(diagnostics) = why {
                return Err(Error::input(
                    format!("{}\n{task}.rs does not compile", diagnostics.trim_end()),
                    "fix it and try again",
                ));
            }
        }
        Ok(CompiledSubmission {
            submission,
            sandbox,
            program,
        })
    }
}
