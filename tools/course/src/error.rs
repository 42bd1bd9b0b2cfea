//! The one error of the command, and the exit code that goes with it.

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
}

/// Whose turn it is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Fault {
    /// The user's: a file or an argument.
    Input,
    /// The machine's, or our own.
    Environment,
}

/// The result of everything here that can fail.
pub type Result<T> = std::result::Result<T, Error>;

impl Error {
    /// A file or an argument is wrong.
    pub fn input(problem: impl Into<String>, remedy: impl Into<String>) -> Error {
        Error {
            fault: Fault::Input,
            problem: problem.into(),
            remedy: remedy.into(),
        }
    }

    /// Something is missing or broken that the user's files cannot mend.
    pub fn environment(problem: impl Into<String>, remedy: impl Into<String>) -> Error {
        Error {
            fault: Fault::Environment,
            problem: problem.into(),
            remedy: remedy.into(),
        }
    }

    /// A file cannot be read or written.
    pub fn file(path: &Path, error: &dyn fmt::Display) -> Error {
        Error::environment(
            format!("{}: {error}", path.display()),
            "see that the file can be read, and its folder written",
        )
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

impl std::error::Error for Error {}

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
