//! From six answer files to a program.
//!
//! Only the answers travel. `main.rs`, `intersect_ray.rs` and the compiler's flags
//! are ours, whatever else lies in the student's folder.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use sha2::{Digest, Sha256};

use crate::assignment::Assignment;
use crate::blame::{self, Diagnostic};
use crate::checkout::Checkout;
use crate::error::{Error, Result};
use crate::harness::Harness;
use crate::sandbox::Sandbox;
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
}

/// Why a stub stands where an answer should.
#[derive(Clone, Debug, PartialEq)]
pub enum Replaced {
    /// There was no usable file.
    Unusable(Unusable),
    /// It does not compile: the compiler's own words about that file.
    DoesNotCompile(String),
}

/// Compiles a submission, replacing by its stub each answer that is missing or does
/// not compile, so that one bad file costs one task.
///
/// # Errors
/// If even the stubs do not compile, or the compiler cannot be run.
pub fn compile(
    submission: &Submission,
    assignment: &Assignment,
    checkout: &Checkout,
    sandbox: &Sandbox,
) -> Result<Program> {
    let harness = Harness::gather(checkout)?;
    let stubs = Submission::find(&assignment.handout(), assignment)?;
    let mut replaced = BTreeMap::new();
    for answer in &submission.answers {
        if let Err(unusable) = &answer.text {
            replaced.insert(answer.task.clone(), Replaced::Unusable(unusable.clone()));
        }
    }
    // Each round replaces at least one answer, so there are at most as many rounds.
    for _ in 0..=submission.answers.len() {
        let compile = |replaced: &Replacements| {
            let sources = sources(submission, &stubs, assignment, replaced)?;
            build(&sources, checkout, &harness, sandbox)
        };
        match compile(&replaced)? {
            Built::Program(executable) => {
                return Ok(Program {
                    executable,
                    replaced,
                });
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
        "restore the assignment's `handout` folder",
    ))
}

/// File names and texts of a whole program.
type Sources = BTreeMap<String, String>;

fn sources(
    submission: &Submission,
    stubs: &Submission,
    assignment: &Assignment,
    replaced: &Replacements,
) -> Result<Sources> {
    let mut sources = Sources::new();
    for answer in stubs.answers.iter().chain(&submission.answers) {
        if let Ok(text) = &answer.text
            && (!sources.contains_key(&answer.task) || !replaced.contains_key(&answer.task))
        {
            sources.insert(answer.task.clone(), text.clone());
        }
    }
    let mut sources: Sources = sources
        .into_iter()
        .map(|(task, text)| (format!("{task}.rs"), text))
        .collect();
    for fixed in assignment.fixed_files() {
        let path = assignment.handout().join("src").join(&fixed);
        let text = fs::read_to_string(&path).map_err(|error| {
            Error::environment(
                format!("cannot read {}: {error}", path.display()),
                "restore the assignment's `handout` folder",
            )
        })?;
        sources.insert(fixed, text);
    }
    Ok(sources)
}

enum Built {
    Program(PathBuf),
    Refused(Vec<Diagnostic>),
}

fn build(
    sources: &Sources,
    checkout: &Checkout,
    harness: &Harness,
    sandbox: &Sandbox,
) -> Result<Built> {
    let folder = checkout
        .scratch()
        .join("programs")
        .join(fingerprint(sources, harness));
    let executable = folder.join("out").join("submission");
    if executable.is_file() {
        return Ok(Built::Program(executable));
    }
    let failed = |error: std::io::Error| {
        Error::environment(
            format!("cannot write to {}: {error}", folder.display()),
            "free some disk space and check that the folder can be written",
        )
    };
    let out = folder.join("out");
    fs::create_dir_all(&out)
        .and_then(|()| fs::create_dir_all(folder.join("src")))
        .map_err(failed)?;
    for (name, text) in sources {
        fs::write(folder.join("src").join(name), text).map_err(failed)?;
    }
    let mut rustc = sandbox.compiler(&folder, &out, &harness.folder)?;
    arguments(&mut rustc, harness);
    let output = rustc.output().map_err(|error| {
        Error::environment(
            format!("cannot start rustc: {error}"),
            "install Rust from rustup.rs",
        )
    })?;
    let unfinished = out.join("unfinished");
    if output.status.success() && unfinished.is_file() {
        fs::rename(unfinished, &executable).map_err(failed)?;
        return Ok(Built::Program(executable));
    }
    let diagnostics = blame::diagnostics(&output.stderr);
    if blame::has_error(&diagnostics) {
        return Ok(Built::Refused(diagnostics));
    }
    Err(Error::environment(
        format!(
            "the compiler failed ({}):\n{}",
            output.status,
            String::from_utf8_lossy(&output.stderr)
        ),
        "check that `rustc` and a C linker work: cargo build --release",
    ))
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
    rustc.args(["-Coverflow-checks=on", "-Awarnings"]);
    rustc.args([
        "--error-format=json",
        "--json=diagnostic-rendered-ansi",
        "-oout/unfinished",
    ]);
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

fn fingerprint(sources: &Sources, harness: &Harness) -> String {
    let mut hash = Sha256::new();
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
    for suspect in stubs.keys().filter(|task| !already.contains_key(*task)) {
        let mut others = stubs.clone();
        others.remove(suspect);
        if let Built::Refused(diagnostics) = compile(&others)? {
            let text = blame::rendered(&diagnostics);
            blamed.insert(suspect.clone(), Replaced::DoesNotCompile(text));
        }
    }
    Ok(blamed)
}
