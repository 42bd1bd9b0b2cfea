//! From six answer files to a program.
//!
//! Only the answers travel. `main.rs`, `intersect_ray.rs` and the compiler's flags
//! are ours, whatever else lies in the student's folder.

mod blame;
mod build;
mod harness;
mod prune;
mod whole;

use std::collections::BTreeMap;
use std::path::PathBuf;

use pinhole::ask::Stop;

use crate::assignment::Assignment;
use crate::checkout::Checkout;
use crate::error::{Error, Result};
use crate::handout_record::Package;
use crate::sandbox::Sandbox;
use crate::stubs;
use crate::submission::{Submission, Unusable};
use crate::timings::timed;
use build::{Built, Sources, build};
use harness::Harness;
pub use whole::Whole;

/// Answers that were replaced by their stubs, by task, and why.
pub type Replacements = BTreeMap<String, Replaced>;

/// A submission that runs.
#[derive(Clone, Debug)]
pub struct Program {
    /// The executable.
    pub executable: PathBuf,
    /// Answers that were replaced by their stubs, and why.
    pub replaced: Replacements,
    /// Raised when nobody wants its answers any more.
    pub stop: Stop,
}

/// Why a stub stands where an answer should.
#[derive(Clone, Debug, PartialEq)]
pub enum Replaced {
    /// There was no usable file.
    Unusable(Unusable),
    /// It does not compile: the compiler's own words about that file.
    DoesNotCompile(String),
}

/// Compiles submissions; made once, it serves many.
#[derive(Clone)]
pub struct Compiler {
    /// Where finished programs lie.
    programs: PathBuf,
    sandbox: Sandbox,
    harness: Harness,
    /// Not the handout's folder: students fill that.
    pristine: Package,
}

/// Compiles one submission: see [`Compiler::compile`].
pub fn compile(
    submission: &Submission,
    assignment: &Assignment,
    checkout: &Checkout,
    sandbox: &Sandbox,
) -> Result<Program> {
    Compiler::new(assignment, checkout, sandbox)?.compile(submission)
}

impl Compiler {
    /// Builds the harness if need be.
    pub fn new(
        assignment: &Assignment,
        checkout: &Checkout,
        sandbox: &Sandbox,
    ) -> Result<Compiler> {
        Ok(Compiler {
            programs: checkout.scratch().join("programs"),
            sandbox: sandbox.clone(),
            harness: timed("find the harness", || Harness::gather(checkout))?,
            pristine: stubs::pristine(assignment, checkout)?,
        })
    }

    /// A compiler for one untrusted submission, with a sandbox and a folder of its own.
    pub fn apart(&self, sandbox: &Sandbox, programs: PathBuf) -> Compiler {
        Compiler {
            programs,
            sandbox: sandbox.clone(),
            ..self.clone()
        }
    }

    /// Compiles a submission, replacing by its stub each answer that is missing or does
    /// not compile, so that one bad file costs one task.
    ///
    /// # Errors
    /// If even the stubs do not compile, or the compiler cannot be run.
    pub fn compile(&self, submission: &Submission) -> Result<Program> {
        match self.compile_until(submission, &mut |_| false)? {
            Attempt::Program(program) => Ok(program),
            Attempt::Enough => unreachable!("no replacement is ever enough"),
        }
    }

    /// Compiles a submission, but stops as soon as the answers that have been replaced are
    /// `enough` to know: the compiler reports errors long before it has built the rest.
    pub fn compile_until(
        &self,
        submission: &Submission,
        enough: &mut dyn FnMut(&Replacements) -> bool,
    ) -> Result<Attempt> {
        let mut replaced = Replacements::new();
        for answer in &submission.answers {
            if let Err(unusable) = &answer.text {
                replaced.insert(answer.task.clone(), Replaced::Unusable(unusable.clone()));
            }
        }
        // Each round replaces at least one answer, so there are at most as many rounds.
        for _ in 0..=submission.answers.len() {
            if enough(&replaced) {
                return Ok(Attempt::Enough);
            }
            let compile = |replaced: &Replacements| {
                let sources = sources(submission, &self.pristine, replaced);
                build(&sources, &self.programs, &self.harness, &self.sandbox)
            };
            match compile(&replaced)? {
                Built::Program(executable) => {
                    return Ok(Attempt::Program(Program {
                        executable,
                        replaced,
                        stop: Stop::default(),
                    }));
                }
                Built::Refused(diagnostics) => {
                    let mut blamed = blame::by_place(&diagnostics, submission, &replaced);
                    if blamed.is_empty() {
                        blamed = blame_alone(submission, &replaced, compile)?;
                    }
                    if blamed.is_empty() {
                        return Err(blame::not_theirs(&diagnostics));
                    }
                    replaced.extend(blamed);
                }
            }
        }
        Err(Error::environment(
            "the stubs do not compile",
            "restore the assignment's `reference` folder, which they are made from",
        ))
    }
}

/// The result of [`Compiler::compile_until`].
pub enum Attempt {
    /// A program.
    Program(Program),
    /// The caller knows enough without one.
    Enough,
}

/// The fixed files, and each answer or its stub.
fn sources(submission: &Submission, pristine: &Package, replaced: &Replacements) -> Sources {
    let ours = pristine.iter().filter_map(|(path, text)| {
        let name = path.strip_prefix("src").ok()?.to_str()?;
        Some((name.to_owned(), text.clone()))
    });
    let mut sources: Sources = ours.collect();
    for answer in submission
        .answers
        .iter()
        .filter(|answer| !replaced.contains_key(&answer.task))
    {
        if let Ok(text) = &answer.text {
            sources.insert(format!("{}.rs", answer.task), text.clone());
        }
    }
    sources
}

/// The answers that fail even among stubs. This finds who is to blame for an error
/// that shows in a file of ours: a deleted function or `impl`, say.
///
/// Nobody is, if the stubs alone fail too: then the fault is the machine's or ours.
fn blame_alone(
    submission: &Submission,
    already: &Replacements,
    compile: impl Fn(&Replacements) -> Result<Built>,
) -> Result<Replacements> {
    let tasks = submission.answers.iter().map(|answer| answer.task.clone());
    let stubs: Replacements = tasks
        .map(|task| (task, Replaced::Unusable(Unusable::Missing)))
        .collect();
    if let Built::Refused(_) = compile(&stubs)? {
        return Ok(Replacements::new());
    }
    let mut blamed = Replacements::new();
    let suspects = || stubs.keys().filter(|task| !already.contains_key(*task));
    for suspect in suspects() {
        let mut others = stubs.clone();
        others.remove(suspect);
        if let Built::Refused(diagnostics) = compile(&others)? {
            let text = blame::rendered(&diagnostics);
            blamed.insert(suspect.clone(), Replaced::DoesNotCompile(text));
        }
    }
    if blamed.is_empty() {
        let text = "each of these answers compiles alone, but not together with the others\n";
        blamed.extend(suspects().map(|task| (task.clone(), Replaced::DoesNotCompile(text.into()))));
    }
    Ok(blamed)
}
