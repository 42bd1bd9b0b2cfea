//! The one error type of the command, and its exit code.

use std::fmt;
use std::path::Path;
use std::process::ExitCode;

/// Why a command could not do its work.
#[derive(Debug)]
pub struct Error {
    /// Who has to act on it.
    pub fault: Fault,
    /// What is wrong, one sentence without a full stop.
    pub problem: String,
    /// What to do about it.
    pub remedy: String,
    /// The error that caused it, whose message is part of the problem's.
    source: Option<Source>,
}

type Source = Box<dyn std::error::Error + Send + Sync>;

/// Who has to act on an error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Fault {
    /// The user: a file or an argument is wrong.
    Input,
    /// The machine's administrator or Pinhole's developers.
    Environment,
}

/// The result of everything in this package that can fail.
pub type Result<T, E = Error> = std::result::Result<T, E>;

impl Error {
    /// A file or an argument is wrong.
    pub fn input(problem: impl Into<String>, remedy: impl Into<String>) -> Error {
        Error {
            fault: Fault::Input,
            problem: problem.into(),
            remedy: remedy.into(),
            source: None,
        }
    }

    /// Something is missing or broken, and changes to the user's files can't fix it.
    pub fn environment(problem: impl Into<String>, remedy: impl Into<String>) -> Error {
        Error {
            fault: Fault::Environment,
            problem: problem.into(),
            remedy: remedy.into(),
            source: None,
        }
    }

    /// A file cannot be read or written.
    pub fn file(path: &Path) -> Error {
        Error::environment(
            path.display().to_string(),
            "check that you may read the file and write to its folder",
        )
    }

    /// This error with its cause. If several steps can fail in the same way, make the error once,
    /// and call this where one of them fails.
    pub fn because(&self, source: impl Into<Source>) -> Error {
        let source = source.into();
        Error {
            fault: self.fault,
            problem: format!("{}: {source}", self.problem),
            remedy: self.remedy.clone(),
            source: Some(source),
        }
    }

    /// 2 for the user's fault, 3 for any other.
    pub fn exit_code(&self) -> ExitCode {
        match self.fault {
            Fault::Input => ExitCode::from(2),
            Fault::Environment => ExitCode::from(3),
        }
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}\n  remedy: {}", self.problem, self.remedy)
    }
}

impl std::error::Error for Error {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        let source = self.source.as_deref()?;
        Some(source)
    }
}

/// Adds what failed and the remedy to an error of another library.
pub trait ResultExt<T> {
    /// The user's file or argument is to blame.
    fn or_input(self, problem: impl fmt::Display, remedy: impl Into<String>) -> Result<T>;

    /// The machine or Pinhole is to blame.
    fn or_environment(self, problem: impl fmt::Display, remedy: impl Into<String>) -> Result<T>;

    /// Something failed, and this is the [cause](Error::because).
    fn or_fail(self, what: &Error) -> Result<T>;
}

impl<T, E: Into<Source>> ResultExt<T> for std::result::Result<T, E> {
    fn or_input(self, problem: impl fmt::Display, remedy: impl Into<String>) -> Result<T> {
        self.map_err(|source| Error::input(problem.to_string(), remedy).because(source))
    }

    fn or_environment(self, problem: impl fmt::Display, remedy: impl Into<String>) -> Result<T> {
        self.map_err(|source| Error::environment(problem.to_string(), remedy).because(source))
    }

    fn or_fail(self, what: &Error) -> Result<T> {
        self.map_err(|source| what.because(source))
    }
}

impl From<pinhole::Error> for Error {
    fn from(error: pinhole::Error) -> Error {
        let place = error
            .position
            .map(|(line, column)| format!(":{line}:{column}"));
        let place = place.unwrap_or_default();
        let problem = format!("{}{place}: {}", error.path.display(), error.problem);
        Error::input(problem, error.remedy)
    }
}

#[cfg(test)]
mod tests {
    use std::error::Error as _;
    use std::io;

    use super::*;

    #[test]
    fn error_keeps_its_cause_and_prints_it_once() {
        let lost: io::Result<()> = Err(io::Error::other("the disk is gone"));
        let error = lost.or_environment(format_args!("cannot read {}", "a.toml"), "look for it");
        let error = error.expect_err("it failed");
        let said = "cannot read a.toml: the disk is gone\n  remedy: look for it";
        assert_eq!(error.to_string(), said);
        assert_eq!(error.fault, Fault::Environment);
        let source = error.source().expect("there is one");
        assert_eq!(source.to_string(), "the disk is gone");
    }
}
