//! Some subcommands belong to other programs of the course. This module passes them on with all
//! their arguments, as cargo does for `cargo-CMD`. Such a program is built when it is first needed,
//! so a student's build doesn't compile it.

use std::ffi::OsString;
#[cfg(unix)]
use std::os::unix::process::CommandExt;
use std::path::PathBuf;
use std::process::{Command, ExitCode, Stdio};
use std::{env, fs};

use pinhole_course::checkout::Checkout;
use pinhole_course::error::{Error, Result, ResultExt};
use pinhole_course::handout_record::HandoutRecord;
use pinhole_course::progress::patiently;
use pinhole_course::rust_tool::rust_tool;
use pinhole_report::program::{self, Status};
use serde_json::Value;

/// A program of the course.
struct Program {
    package: &'static str,
    folder: &'static str,
    commands: &'static [&'static str],
    /// Whether it is built for this processor, rather than for any of the same family.
    uses_vectors: bool,
}

const PROGRAMS: [Program; 3] = [
    Program {
        package: "pinhole-instructor",
        folder: "tools/instructor",
        commands: &["golden", "grade", "dispute", "merge", "handout", "validate"],
        uses_vectors: false,
    },
    Program {
        package: "pinhole-study",
        folder: "tools/study",
        commands: &["study", "plan"],
        uses_vectors: true,
    },
    Program {
        package: "pinhole-book",
        folder: "tools/book",
        commands: &["book"],
        uses_vectors: false,
    },
];

/// The subcommands of other programs.
pub fn commands() -> impl Iterator<Item = &'static str> {
    PROGRAMS
        .iter()
        .flat_map(|program| program.commands)
        .copied()
}

/// Runs the program that has the subcommand on the command line; `None` if it is one of ours or
/// unknown.
pub fn pass_on() -> Option<ExitCode> {
    let words: Vec<OsString> = env::args_os().skip(1).collect();
    let program = program_of(&words)?;
    let json = words.iter().any(|word| word == "--json");
    let mut code = ExitCode::SUCCESS;
    let started = program::run(json, || {
        code = program.run(&words)?;
        Ok(Status::Well)
    });
    // Return the other program's exit code, unless it could not be started.
    Some(if started == ExitCode::SUCCESS {
        code
    } else {
        started
    })
}

fn program_of(words: &[OsString]) -> Option<&'static Program> {
    let command = words.first()?.to_str()?;
    // Only the study can cast exactly or by a plan.
    let is_study = |word: &OsString| {
        word.to_str().is_some_and(|word| {
            word == "--exact" || word == "--plan" || word.starts_with("--plan=")
        })
    };
    let command = match command {
        "render" if words.iter().any(is_study) => "plan",
        command => command,
    };
    PROGRAMS
        .iter()
        .find(|program| program.commands.contains(&command))
}

impl Program {
    fn run(&self, words: &[OsString]) -> Result<ExitCode> {
        let checkout = Checkout::find()?;
        let manifest = checkout.root().join(self.folder).join("Cargo.toml");
        if !manifest.is_file() || HandoutRecord::read(checkout.root())?.is_some() {
            return Err(Error::input(
                "this is a student's repository, which has no commands for instructors, for the \
                 study or for the book",
                "run this in the instructor's repository",
            ));
        }
        // Build in the checkout, but run in the user's folder, because paths are relative to it. We
        // don't use `cargo run`, because in the user's folder it would obey the settings there.
        let mut cargo = rust_tool("cargo", checkout.root());
        cargo
            .args(["build", "--release", "--manifest-path"])
            .arg(manifest)
            .arg("--message-format=json-render-diagnostics")
            .stderr(Stdio::inherit());
        if self.target() == VECTOR_TARGET {
            // Settings in `RUSTFLAGS`, if there are any, take the place of the ones in this file.
            let settings = checkout.root().join("tools/study/x86-64-v3.toml");
            cargo.arg("--config").arg(settings);
        }
        let what = format!("building {}", self.package);
        let built = if self.is_built(&checkout) {
            cargo.arg("--quiet");
            let record = checkout.scratch().join(format!("{}.seconds", self.package));
            patiently(&what, &record, || cargo.output())
        } else {
            // Let cargo print its progress.
            anstream::eprintln!("{what}, which takes a while the first time …");
            cargo.output()
        };
        let built = built.or_environment("cannot start cargo", "install Rust")?;
        let executable = executable(&built.stdout).ok_or_else(|| {
            Error::environment(
                format!("{} does not build", self.package),
                "see cargo's message above",
            )
        })?;
        let mut program = Command::new(&executable);
        program.args(words);
        // On Unix, this process becomes the program, so a signal to this process reaches the program.
        #[cfg(unix)]
        let status = Err::<std::process::ExitStatus, _>(program.exec());
        #[cfg(not(unix))]
        let status = program.status();
        let status = status.or_environment(
            format_args!("cannot start {}", executable.display()),
            "run `cargo clean`, then this command again",
        )?;
        let code = status.code().and_then(|code| u8::try_from(code).ok());
        Ok(ExitCode::from(code.unwrap_or(3)))
    }

    fn is_built(&self, checkout: &Checkout) -> bool {
        let name = format!("{}{}", self.package, env::consts::EXE_SUFFIX);
        let executable: PathBuf = checkout
            .root()
            .join(self.target())
            .join("release")
            .join(name);
        fs::metadata(executable).is_ok()
    }

    /// The folder for what cargo builds.
    fn target(&self) -> &'static str {
        match self.uses_vectors && has_vectors() {
            true => VECTOR_TARGET,
            false => "target",
        }
    }
}

/// The folder that `tools/study/x86-64-v3.toml` names.
const VECTOR_TARGET: &str = "target/x86-64-v3";

/// Whether this processor has everything that x86-64-v3 requires.
fn has_vectors() -> bool {
    #[cfg(target_arch = "x86_64")]
    {
        is_x86_feature_detected!("avx2")
            && is_x86_feature_detected!("bmi1")
            && is_x86_feature_detected!("bmi2")
            && is_x86_feature_detected!("f16c")
            && is_x86_feature_detected!("fma")
            && is_x86_feature_detected!("lzcnt")
            && is_x86_feature_detected!("movbe")
    }
    #[cfg(not(target_arch = "x86_64"))]
    false
}

/// The program that cargo reports to have built.
fn executable(messages: &[u8]) -> Option<PathBuf> {
    let lines = messages.split(|byte| *byte == b'\n');
    let messages = lines.filter_map(|line| serde_json::from_slice::<Value>(line).ok());
    let mut programs = messages.filter_map(|message| Some(message["executable"].as_str()?.into()));
    programs.next_back()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn package_of(line: &str) -> Option<&'static str> {
        let words: Vec<OsString> = line.split(' ').map(OsString::from).collect();
        program_of(&words).map(|program| program.package)
    }

    #[test]
    fn every_subcommand_finds_the_program_that_has_it() {
        assert_eq!(
            package_of("grade --out grades class"),
            Some("pinhole-instructor")
        );
        assert_eq!(package_of("study --quick"), Some("pinhole-study"));
        assert_eq!(package_of("render bunny --exact"), Some("pinhole-study"));
        assert_eq!(
            package_of("render bunny --plan 1e-6"),
            Some("pinhole-study")
        );
        assert_eq!(package_of("render bunny"), None);
        assert_eq!(package_of("book check"), Some("pinhole-book"));
        assert_eq!(package_of("check grade"), None);
    }
}
