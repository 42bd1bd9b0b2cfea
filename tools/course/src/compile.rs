//! Compiles a submission's answer files to a program.
//!
//! Only the answers come from the student's folder. `main.rs`, `intersect_ray.rs` and the
//! compiler's flags are always ours.

mod blame;
mod build;
mod compiled_submission;
mod harness;
mod prune;
mod rounds;

use std::collections::{BTreeMap, BTreeSet};
use std::path::PathBuf;

use pinhole::ask::Stop;

use crate::assignment::Assignment;
use crate::checkout::Checkout;
use crate::error::{Error, Result};
use crate::handout_record::Package;
use crate::sandbox::Sandbox;
use crate::stubs;
use crate::submission::{AnswerFileProblem, Submission};
use crate::timings::timed;
pub use compiled_submission::CompiledSubmission;
use harness::Harness;
use rounds::Rounds;

/// Answers that were replaced by their stubs, by task, and why.
pub type Replacements = BTreeMap<String, Replacement>;

/// A submission that runs.
#[derive(Clone, Debug)]
pub struct Program {
    /// The executable.
    pub executable: PathBuf,
    /// Answers that were replaced by their stubs, and why.
    pub replaced: Replacements,
    /// The tasks whose answer is the stub, either because it was replaced or because it is still
    /// what was handed out.
    pub stubs: BTreeSet<String>,
    /// The same program with our answer to the task of an earlier assignment.
    pub with_ours: WithOurs,
    /// What the compiler warned about, by task.
    pub warnings: BTreeMap<String, String>,
    /// Raised when its answers are no longer needed.
    pub stop: Stop,
}

/// A program with our answer to the task of an earlier assignment instead of the student's.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum WithOurs {
    /// No such program is needed, because the student's answer is not used.
    #[default]
    Same,
    /// This executable.
    Executable(PathBuf),
    /// The other answers need something of the student's answer that ours doesn't have.
    DoesNotCompile,
}

/// Why an answer was replaced by its stub.
#[derive(Clone, Debug, PartialEq)]
pub enum Replacement {
    /// There was no usable file.
    Unusable(AnswerFileProblem),
    /// It does not compile: the compiler's own words about that file.
    DoesNotCompile(String),
}

/// Compiles any number of submissions.
#[derive(Clone)]
pub struct Compiler {
    /// The folder of compiled programs.
    programs: PathBuf,
    sandbox: Sandbox,
    harness: Harness,
    /// The handout with untouched stubs. It is not read from the handout's folder, because
    /// students write there.
    pristine: Package,
    /// The task of an earlier assignment, if students may hand in its answer again.
    earlier: Option<String>,
    /// Whether answers may use any attribute and macro.
    allows_everything: bool,
    /// Whether messages name the student's files by paths that open from the current folder.
    names_places: bool,
    /// Whether to give up when the compiler is late, because other work may have held it up.
    stops_when_late: bool,
}

/// Compiles one submission for someone who can edit it: see [`Compiler::compile`] and
/// [`Compiler::naming_places`].
pub fn compile(
    submission: &Submission,
    assignment: &Assignment,
    checkout: &Checkout,
    sandbox: &Sandbox,
) -> Result<Program> {
    let compiler = Compiler::new(assignment, checkout, sandbox)?;
    compiler.naming_places().compile(submission)
}

impl Compiler {
    /// Makes a compiler, and builds the harness if needed.
    pub fn new(
        assignment: &Assignment,
        checkout: &Checkout,
        sandbox: &Sandbox,
    ) -> Result<Compiler> {
        let earlier = assignment.earlier.as_ref();
        Ok(Compiler {
            programs: sandbox.scratch(checkout).join("programs"),
            sandbox: sandbox.clone(),
            harness: timed("find the harness", || {
                Harness::find(checkout, &sandbox.scratch(checkout))
            })?,
            pristine: stubs::pristine(assignment, checkout)?,
            earlier: earlier.map(|earlier| earlier.task.name.clone()),
            allows_everything: false,
            names_places: false,
            stops_when_late: false,
        })
    }

    /// This compiler, but without the [`allow_list`] if `everything` is allowed. Tests of the
    /// sandbox use it.
    pub fn allowing(self, everything: bool) -> Compiler {
        Compiler {
            allows_everything: everything,
            ..self
        }
    }

    /// This compiler, but messages name a student's files by paths that open from the current
    /// folder instead of by their names alone.
    pub fn naming_places(self) -> Compiler {
        Compiler {
            names_places: true,
            ..self
        }
    }

    /// This compiler, set to stop when it is late; see [`Attempt::Late`].
    pub fn stopping_when_late(self, stops: bool) -> Compiler {
        Compiler {
            stops_when_late: stops,
            ..self
        }
    }

    /// A compiler for one untrusted submission, with its own sandbox and folder.
    pub fn apart(&self, sandbox: &Sandbox, programs: PathBuf) -> Compiler {
        Compiler {
            programs,
            sandbox: sandbox.clone(),
            ..self.clone()
        }
    }

    /// Compiles a submission. Each answer that is missing or does not compile is replaced with its
    /// stub, so that one bad file costs only one task. An answer that compiles with the others is not
    /// replaced.
    ///
    /// # Errors
    /// If even the stubs do not compile, or the compiler cannot be run.
    pub fn compile(&self, submission: &Submission) -> Result<Program> {
        match self.compile_until(submission, &mut |_| false)? {
            Attempt::Program(program) => Ok(program),
            Attempt::Enough => unreachable!("compiling is never stopped early"),
            Attempt::Late => Err(Error::environment(
                "the compiler did not finish, perhaps because this machine was busy",
                "run this command again",
            )),
        }
    }

    /// Compiles a submission, but stops as soon as the replaced answers are `enough` for the
    /// caller. The compiler reports errors long before it has built the rest.
    pub fn compile_until(
        &self,
        submission: &Submission,
        enough: &mut dyn FnMut(&Replacements) -> bool,
    ) -> Result<Attempt> {
        let is_done = || self.sandbox.is_done_compiling();
        Rounds::new(self, submission).attempt(&is_done, enough)
    }
}

/// The result of [`Compiler::compile_until`].
pub enum Attempt {
    /// A program.
    Program(Program),
    /// No program, because the caller already knows enough.
    Enough,
    /// The compiler was late. Try again when nothing else runs.
    Late,
}
