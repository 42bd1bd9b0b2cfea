//! What all our programs share: exit codes, errors, panics.

use std::ffi::OsString;
use std::panic::{self, PanicHookInfo};
use std::path::Path;
use std::process::ExitCode;

use crate::escape::printable_coloured;
use pinhole_course::error::{Error, Result};

/// How a command ended.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Status {
    /// Exit code 0.
    Well,
    /// Exit code 1.
    JudgedWrong,
    /// Exit code 3: part of the work could not be done, and the output says which.
    Incomplete,
}

/// Runs a command and turns its result into an exit code. With `json`, an error is also
/// printed as a document on standard output.
pub fn run(json: bool, command: impl FnOnce() -> Result<Status>) -> ExitCode {
    panic::set_hook(Box::new(report_panic));
    let command = || {
        refuse_files_as_options()?;
        command()
    };
    match panic::catch_unwind(panic::AssertUnwindSafe(command)) {
        Ok(Ok(Status::Well)) => ExitCode::SUCCESS,
        Ok(Ok(Status::JudgedWrong)) => ExitCode::from(1),
        Ok(Ok(Status::Incomplete)) => ExitCode::from(3),
        Ok(Err(error)) => {
            if json {
                let Error {
                    problem, remedy, ..
                } = &error;
                anstream::println!(
                    "{:#}",
                    serde_json::json!({ "error": problem, "remedy": remedy })
                );
            }
            anstream::eprint!("{}", in_words(&error));
            error.exit_code()
        }
        Err(_) => ExitCode::from(3),
    }
}

/// Refuses options that are also the names of files here. The shell puts a student's file with such
/// a name in the place of `*`.
fn refuse_files_as_options() -> Result<()> {
    let mut options = std::env::args_os().skip(1).take_while(|it| it != "--");
    let is_file = |it: &OsString| {
        it.as_encoded_bytes().starts_with(b"-") && Path::new(it).symlink_metadata().is_ok()
    };
    match options.find(is_file) {
        None => Ok(()),
        Some(name) => Err(Error::input(
            format!(
                "{} is an option, but also a file in this folder",
                name.display()
            ),
            "if you wrote `*`, write `./*` instead; otherwise, run the command in another folder",
        )),
    }
}

/// An error for the terminal. It may quote names that students chose, and the compiler's messages
/// about their code.
fn in_words(error: &Error) -> String {
    printable_coloured(&format!("pinhole: {error}"))
}

/// Prints what to do after a panic, which is always a bug in Pinhole.
fn report_panic(info: &PanicHookInfo<'_>) {
    let what = info.payload_as_str().unwrap_or("(no message)");
    // A program that reads our output may stop early, as `head` does. That is not a bug.
    if !what.starts_with("failed printing to") {
        let place = info.location().map(ToString::to_string).unwrap_or_default();
        eprintln!("pinhole: internal error at {place}: {what}\n  remedy: report it");
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_error_that_quotes_a_student_cannot_control_the_terminal() {
        let problem = "\u{1b}[31merror\u{1b}[0m: \u{1b}]52;c;eA==\u{7}\u{202e}\nnot compiled";
        let words = in_words(&Error::input(problem, "fix it"));
        assert_eq!(
            words,
            "pinhole: \u{1b}[31merror\u{1b}[0m: ]52;c;eA==\\u{7}\\u{202e}\u{1b}[0m\nnot compiled\n  \
             remedy: fix it\n"
        );
    }
}
