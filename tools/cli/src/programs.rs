//! Subcommands that other programs of the course have: they are passed on, arguments
//! untouched, to a program that is built when it is first asked for, as cargo does with
//! `cargo-CMD`. So a student's build compiles nothing of them.

use std::ffi::OsString;
use std::path::PathBuf;
use std::process::{Command, ExitCode};
use std::{env, fs};

use pinhole_course::checkout::Checkout;
use pinhole_course::error::{Error, Result};
use pinhole_course::handout_record::HandoutRecord;
use pinhole_report::program::{self, Status};

/// A program of the course.
struct Program {
    package: &'static str,
    folder: &'static str,
    /// The profile that cargo builds it with.
    profile: &'static str,
    commands: &'static [&'static str],
}

const PROGRAMS: [Program; 3] = [
    Program {
        package: "pinhole-instructor",
        folder: "tools/instructor",
        profile: "instructor",
        commands: &["golden", "grade", "merge", "handout", "validate"],
    },
    Program {
        package: "pinhole-study",
        folder: "tools/study",
        profile: "release",
        commands: &["study", "plan"],
    },
    Program {
        package: "pinhole-book",
        folder: "tools/book",
        profile: "release",
        commands: &["book"],
    },
];

/// Runs the program that has the subcommand on the command line; `None` if it is one of
/// ours, or nobody's.
pub fn pass_on() -> Option<ExitCode> {
    let words: Vec<OsString> = env::args_os().skip(1).collect();
    let program = program_of(&words)?;
    let json = words.iter().any(|word| word == "--json");
    let mut code = ExitCode::SUCCESS;
    let started = program::run(json, || {
        code = program.run(&words)?;
        Ok(Status::Well)
    });
    // What the other program said with its exit code, unless it could not be started.
    Some(if started == ExitCode::SUCCESS {
        code
    } else {
        started
    })
}

fn program_of(words: &[OsString]) -> Option<&'static Program> {
    let command = words.first()?.to_str()?;
    // The study has casters of its own.
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
                "this is a student's repository, which has neither the instructor's commands nor \
                 the study and the book",
                "run this in a checkout of the course",
            ));
        }
        let cargo = env::var_os("CARGO").unwrap_or("cargo".into());
        let mut command = Command::new(cargo);
        // Not from the checkout's top folder: paths are relative to where the user stands.
        command
            .args(["run", "--profile", self.profile, "--manifest-path"])
            .arg(manifest);
        if self.is_built(&checkout) {
            command.arg("--quiet");
        } else {
            anstream::eprintln!(
                "building {}, which takes a while the first time …",
                self.package
            );
        }
        let status = command.arg("--").args(words).status().map_err(|error| {
            Error::environment(format!("cargo does not start: {error}"), "install Rust")
        })?;
        let code = status.code().and_then(|code| u8::try_from(code).ok());
        Ok(ExitCode::from(code.unwrap_or(3)))
    }

    fn is_built(&self, checkout: &Checkout) -> bool {
        let name = format!("{}{}", self.package, env::consts::EXE_SUFFIX);
        let executable: PathBuf = checkout.root().join("target").join(self.profile).join(name);
        fs::metadata(executable).is_ok()
    }
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
