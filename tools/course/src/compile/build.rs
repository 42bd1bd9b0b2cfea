//! Compiles the files of a whole program.

use std::collections::BTreeMap;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::atomic::{AtomicUsize, Ordering};

use hmac_sha256::Hash;

use super::blame::{self, Diagnostic};
use super::harness::Harness;
use super::prune;
use crate::error::{Error, Result, ResultExt};
use crate::private::{allow, make_private};
use crate::sandbox::{CommandResult, Limits, MOST_SAID, Sandbox};
use crate::timings::timed;

/// The executable's name on this system.
const PROGRAM: &str = match cfg!(windows) {
    true => "submission.exe",
    false => "submission",
};

/// A file beside each program: the compiler's warnings, a JSON document on each line.
const WARNINGS: &str = "warnings";

/// The folder of the answers, as the compiler sees it.
pub const SRC: &str = "src";

/// File names and texts of a whole program.
pub type Sources = BTreeMap<String, String>;

/// What the compiler made of sources.
pub enum BuildResult {
    Program {
        executable: PathBuf,
        /// What the compiler warned about.
        warnings: Vec<Diagnostic>,
    },
    Refused {
        diagnostics: Vec<Diagnostic>,
        /// Whether the compiler might finish at another time.
        is_late: bool,
        /// What other than the sources is to blame, if anything. See
        /// [`CommandResult::disturbed_by`].
        disturbed_by: Option<&'static str>,
    },
}

/// Compiles sources into a folder of `programs`, unless it is there already. Messages of the
/// compiler and of panics name the files that are in the folder `shown_in` as its files.
///
/// # Errors
/// If a file cannot be written, or the compiler is not installed.
pub fn build(
    sources: &Sources,
    shown_in: &str,
    programs: &Path,
    harness: &Harness,
    sandbox: &Sandbox,
) -> Result<BuildResult> {
    let folder = programs.join(fingerprint(sources, shown_in, harness, sandbox));
    let executable = folder.join(PROGRAM);
    let failed = Error::environment(
        format!("cannot write to {}", programs.display()),
        "free some disk space and check that you may write to the folder",
    );
    let lock = prune::lock(programs).or_fail(&failed)?;
    if sandbox.is_sealed(&executable) {
        prune::keep(&folder);
        let warnings = fs::read(folder.join(WARNINGS)).unwrap_or_default();
        let warnings = blame::diagnostics(&warnings);
        return Ok(BuildResult::Program {
            executable,
            warnings,
        });
    }
    drop(lock);
    // Compile in a folder of its own, because another command may be compiling the same
    // answers.
    static NEXT: AtomicUsize = AtomicUsize::new(0);
    let turn = NEXT.fetch_add(1, Ordering::Relaxed);
    let fresh = folder.with_extension(format!("{}-{turn}", std::process::id()));
    make_folders(programs, &fresh, sandbox.needs_access()).or_fail(&failed)?;
    let (src, out) = (fresh.join(SRC), fresh.join("out"));
    for (name, text) in sources {
        let file = src.join(name);
        fs::write(&file, text)
            .and_then(|()| allow(&file, 0o644))
            .or_fail(&failed)?;
    }
    let limits = sandbox.within_budget(&Limits::of_compiler());
    let not_started = Error::environment("cannot start rustc", "install Rust from rustup.rs");
    let compile = |more: &[&str]| {
        let mut rustc = sandbox.compiler(&fresh, &harness.folder, &limits)?;
        arguments(&mut rustc, harness, sources, shown_in);
        rustc.args(more);
        timed("rustc", || sandbox.compile(rustc, &limits))
    };
    let mut finished = compile(&[]).or_fail(&not_started)?;
    let is_cut = finished.stderr.len() == MOST_SAID;
    if is_cut
        && !finished.status.success()
        && !blame::has_error(&blame::diagnostics(&finished.stderr))
    {
        // Warnings may have left no room for errors.
        finished = compile(&["-Awarnings"]).or_fail(&not_started)?;
    }
    if finished.status.success() && is_program(&out.join(PROGRAM)) {
        fs::rename(out.join(PROGRAM), fresh.join(PROGRAM))
            .and_then(|()| fs::remove_dir_all(&out))
            // Nobody else should find the answers here later.
            .and_then(|()| fs::remove_dir_all(&src))
            .and_then(|()| sandbox.seal(&fresh, &fresh.join(PROGRAM)))
            .or_fail(&failed)?;
        fs::write(fresh.join(WARNINGS), &finished.stderr).or_fail(&failed)?;
        let built = BuildResult::Program {
            executable: executable.clone(),
            warnings: blame::diagnostics(&finished.stderr),
        };
        let _lock = prune::lock(programs).or_fail(&failed)?;
        if sandbox.is_sealed(&executable) {
            // Another command was faster, and its program may be running.
            prune::keep(&folder);
            fs::remove_dir_all(&fresh).or_fail(&failed)?;
        } else {
            // The folder may exist without a program if an earlier command was stopped while
            // deleting it.
            let _gone_or_absent = fs::remove_dir_all(&folder);
            fs::rename(&fresh, &folder).or_fail(&failed)?;
            prune::prune(programs);
        }
        return Ok(built);
    }
    fs::remove_dir_all(&fresh).or_fail(&failed)?;
    let diagnostics = said(&finished);
    let has_no_space = blame::has_no_space(&diagnostics);
    Ok(BuildResult::Refused {
        is_late: finished.is_late() || has_no_space,
        disturbed_by: finished
            .disturbed_by()
            .or(has_no_space.then_some("no space was left for the files of the compiler")),
        diagnostics,
    })
}

/// Makes a folder to compile in, inside `programs`. If another user of the machine `needs_access`, the
/// sandbox gives the folder to this user later.
fn make_folders(programs: &Path, fresh: &Path, needs_access: bool) -> io::Result<()> {
    let _left_by_a_killed_command = fs::remove_dir_all(fresh);
    fs::create_dir_all(fresh)?;
    // Close it while it is empty. A user who has entered the folder of answers could stay there.
    make_private(fresh)?;
    match needs_access {
        true => allow(programs, 0o711)?,
        false => make_private(programs).and_then(|()| allow(fresh, 0o755))?,
    }
    for folder in [SRC, "out"].map(|name| fresh.join(name)) {
        fs::create_dir(&folder)?;
        allow(&folder, 0o755)?;
    }
    Ok(())
}

/// Whether this is a regular file, as the compiler writes it, and not a link.
fn is_program(path: &Path) -> bool {
    fs::symlink_metadata(path).is_ok_and(|metadata| metadata.is_file())
}

/// The compiler's messages, or one that says why there are none.
fn said(finished: &CommandResult) -> Vec<Diagnostic> {
    let mut diagnostics = blame::diagnostics(&finished.stderr);
    if !blame::has_error(&diagnostics) {
        diagnostics.push(Diagnostic::of_dead_compiler(finished));
    }
    diagnostics
}

/// Adds the compiler's arguments. All paths are relative, so that its messages name files as
/// the student does.
fn arguments(rustc: &mut Command, harness: &Harness, sources: &Sources, shown_in: &str) {
    rustc.args([
        "src/main.rs",
        "--edition=2024",
        "--crate-type=bin",
        "--crate-name=submission",
    ]);
    rustc.args(["-Copt-level=3", "-Ccodegen-units=1", "-Cstrip=debuginfo"]);
    // With overflow checks, an `i - 1` that would wrap around panics and names its line,
    // instead of producing a wrong picture.
    rustc.args(["-Coverflow-checks=on", "-Funsafe_code"]);
    rustc.args(["--error-format=json", "--json=diagnostic-rendered-ansi"]);
    rustc.arg(format!("-oout/{PROGRAM}"));
    for name in sources.keys() {
        // Not every folder of answers holds our files, too.
        if shown_in != SRC && Path::new(shown_in).join(name).is_file() {
            rustc.arg(format!(
                "--remap-path-prefix={SRC}/{name}={shown_in}/{name}"
            ));
        }
    }
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

/// Identifies a build by its sources, the harness and the sandbox. The sandbox counts, because a
/// program compiled without one may contain files that sandboxed code must not read.
fn fingerprint(sources: &Sources, shown_in: &str, harness: &Harness, sandbox: &Sandbox) -> String {
    let mut hash = Hash::new();
    hash.update(format!("{}\n{shown_in}", shown_in.len()));
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
    hex::encode(&hash.finalize()[..12])
}

#[cfg(all(test, unix))]
#[test]
fn nobody_else_can_enter_a_folder_of_answers_before_they_are_written() {
    use crate::private::{is_hidden, is_private};

    for needs_access in [true, false] {
        let programs = tempfile::tempdir().expect("there is room");
        allow(programs.path(), 0o755).expect("it is ours");
        let fresh = programs.path().join("fresh");
        make_folders(programs.path(), &fresh, needs_access).expect("there is room");
        assert_eq!(is_private(&fresh), needs_access);
        assert!(is_hidden(&fresh.join(SRC)));
    }
}
