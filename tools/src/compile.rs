//! From six answer files to a program.
//!
//! Only the answers travel. `main.rs`, `intersect_ray.rs` and the compiler's flags
//! are ours, whatever else lies in the student's folder.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::atomic::{AtomicUsize, Ordering};

use pinhole::ask::Stop;
use sha2::{Digest, Sha256};

use crate::assignment::Assignment;
use crate::blame::{self, Diagnostic};
use crate::checkout::Checkout;
use crate::error::{Error, Result};
use crate::harness::Harness;
use crate::sandbox::{Finished, Limits, Sandbox};
use crate::stubs::{self, Package};
use crate::submission::{Submission, Unusable};

/// Answers whose stubs stand in for them, by task, and why.
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

/// What every submission is compiled with; gathered once, it serves many.
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
            harness: Harness::gather(checkout)?,
            pristine: stubs::pristine(assignment, checkout)?,
        })
    }

    /// The same for one stranger's answers: behind walls of their own, and in a folder that
    /// nobody shares.
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

    /// The same, unless the answers that were to be replaced so far are `enough` to know:
    /// the compiler says what is wrong long before the others' program is built.
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

/// What came of [`Compiler::compile_until`].
pub enum Attempt {
    /// A program.
    Program(Program),
    /// The caller knows enough without one.
    Enough,
}

/// The executable's name, as the system wants it.
const PROGRAM: &str = match cfg!(windows) {
    true => "submission.exe",
    false => "submission",
};

/// File names and texts of a whole program.
type Sources = BTreeMap<String, String>;

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

enum Built {
    Program(PathBuf),
    Refused(Vec<Diagnostic>),
}

fn build(
    sources: &Sources,
    programs: &Path,
    harness: &Harness,
    sandbox: &Sandbox,
) -> Result<Built> {
    let folder = programs.join(fingerprint(sources, harness, sandbox));
    let executable = folder.join("out").join(PROGRAM);
    if executable.is_file() {
        return Ok(Built::Program(executable));
    }
    let failed = |error: std::io::Error| {
        Error::environment(
            format!("cannot write to {}: {error}", programs.display()),
            "free some disk space and check that the folder can be written",
        )
    };
    // A folder of its own until it is complete: another command may be compiling the
    // same answers.
    static NEXT: AtomicUsize = AtomicUsize::new(0);
    let turn = NEXT.fetch_add(1, Ordering::Relaxed);
    let fresh = folder.with_extension(format!("{}-{turn}", std::process::id()));
    let (src, out) = (fresh.join("src"), fresh.join("out"));
    fs::create_dir_all(&out)
        .and_then(|()| fs::create_dir_all(&src))
        .map_err(failed)?;
    for (name, text) in sources {
        fs::write(src.join(name), text).map_err(failed)?;
    }
    let limits = Limits::of_compiler();
    let not_started = |error: std::io::Error| {
        Error::environment(
            format!("cannot start rustc: {error}"),
            "install Rust from rustup.rs",
        )
    };
    let mut rustc = sandbox
        .compiler(&fresh, &harness.folder, &limits)
        .map_err(not_started)?;
    arguments(&mut rustc, harness);
    let finished = sandbox.compile(rustc, &limits).map_err(not_started)?;
    if finished.status.success() && is_program(&out.join(PROGRAM)) {
        return match fs::rename(&fresh, &folder) {
            Err(_) if executable.is_file() => {
                fs::remove_dir_all(&fresh).map_err(failed)?;
                Ok(Built::Program(executable))
            }
            renamed => renamed.map(|()| Built::Program(executable)).map_err(failed),
        };
    }
    fs::remove_dir_all(&fresh).map_err(failed)?;
    Ok(Built::Refused(said(&finished)))
}

/// A file of the compiler's, not a link to anything.
fn is_program(path: &Path) -> bool {
    fs::symlink_metadata(path).is_ok_and(|metadata| metadata.is_file())
}

/// The compiler's words, or why there are none.
fn said(finished: &Finished) -> Vec<Diagnostic> {
    let mut diagnostics = blame::diagnostics(&finished.stderr);
    if !blame::has_error(&diagnostics) {
        diagnostics.push(Diagnostic::of_dead_compiler(finished));
    }
    diagnostics
}

/// Relative paths only, so that the compiler names files as the student does.
fn arguments(rustc: &mut Command, harness: &Harness) {
    rustc.args([
        "src/main.rs",
        "--edition=2024",
        "--crate-type=bin",
        "--crate-name=submission",
    ]);
    rustc.args(["-Copt-level=2", "-Ccodegen-units=1", "-Cstrip=debuginfo"]);
    // An `i - 1` that wraps around shows as a panic in its line, not as a wrong picture.
    rustc.args(["-Coverflow-checks=on", "-Awarnings", "-Funsafe_code"]);
    rustc.args(["--error-format=json", "--json=diagnostic-rendered-ansi"]);
    rustc.arg(format!("-oout/{PROGRAM}"));
    rustc
        .arg("-L")
        .arg(prefixed("dependency=", &harness.folder));
    for (name, file) in &harness.externs {
        rustc
            .arg("--extern")
            .arg(prefixed(&format!("{name}="), file));
    }
}

fn prefixed(prefix: &str, path: &Path) -> std::ffi::OsString {
    let mut text = std::ffi::OsString::from(prefix);
    text.push(path);
    text
}

/// What is compiled, against what, and where: what a trusted compiler could read must
/// not reach a walled one by way of a finished program.
fn fingerprint(sources: &Sources, harness: &Harness, sandbox: &Sandbox) -> String {
    let mut hash = Sha256::new();
    hash.update(sandbox.fingerprint());
    for (name, text) in sources {
        hash.update((name.len() as u64).to_le_bytes());
        hash.update(name);
        hash.update((text.len() as u64).to_le_bytes());
        hash.update(text);
    }
    for (name, file) in &harness.externs {
        hash.update(name);
        hash.update(file.as_os_str().as_encoded_bytes());
        let modified = fs::metadata(file).and_then(|metadata| metadata.modified());
        hash.update(format!("{modified:?}"));
    }
    hash.finalize()
        .iter()
        .take(12)
        .map(|byte| format!("{byte:02x}"))
        .collect()
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
