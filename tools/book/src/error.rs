//! What can be wrong: the book, or the machine that builds it.

use std::fmt;
use std::path::{Path, PathBuf};

/// Something in the book that is wrong, and what to do about it.
#[derive(Clone, Debug, PartialEq)]
pub struct Problem {
    /// The file, from the top of the checkout.
    pub file: PathBuf,
    /// Counted from 1, where there is one.
    pub line: Option<usize>,
    /// One sentence without a full stop.
    pub problem: String,
    /// What to do about it.
    pub remedy: String,
}

impl Problem {
    /// A problem with a line of a file.
    pub fn at(
        file: impl Into<PathBuf>,
        line: usize,
        problem: impl Into<String>,
        remedy: impl Into<String>,
    ) -> Problem {
        Problem {
            line: Some(line),
            ..Problem::of(file, problem, remedy)
        }
    }

    /// A problem with a file.
    pub fn of(
        file: impl Into<PathBuf>,
        problem: impl Into<String>,
        remedy: impl Into<String>,
    ) -> Problem {
        Problem {
            file: file.into(),
            line: None,
            problem: problem.into(),
            remedy: remedy.into(),
        }
    }
}

impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let line = self.line.map(|line| format!(":{line}")).unwrap_or_default();
        let file = self.file.display();
        write!(
            f,
            "{file}{line}: {}\n  remedy: {}",
            self.problem, self.remedy
        )
    }
}

/// Why there is no book.
#[derive(Debug)]
pub enum Error {
    /// Its sources are wrong, each in its place.
    Sources(Vec<Problem>),
    /// The machine lacks something, or this program is at fault.
    Environment {
        /// One sentence without a full stop.
        problem: String,
        /// What to do about it.
        remedy: String,
    },
}

/// The problem and the remedy, said by what does not know which line of which page it is
/// put into.
pub type Wrong = (String, String);

/// The result of everything here that can fail.
pub type Result<T> = std::result::Result<T, Error>;

impl Error {
    /// Something is missing or broken that no page can mend.
    pub fn environment(problem: impl Into<String>, remedy: impl Into<String>) -> Error {
        Error::Environment {
            problem: problem.into(),
            remedy: remedy.into(),
        }
    }

    /// A file cannot be read or written.
    pub fn file(path: &Path, error: &dyn fmt::Display) -> Error {
        let problem = format!("{}: {error}", path.display());
        Error::environment(
            problem,
            "see that the file can be read, and its folder written",
        )
    }
}

impl From<Problem> for Error {
    fn from(problem: Problem) -> Error {
        Error::Sources(vec![problem])
    }
}

impl From<pinhole::Error> for Error {
    fn from(error: pinhole::Error) -> Error {
        let line = error.position.map(|(line, _)| line);
        Error::Sources(vec![Problem {
            line,
            ..Problem::of(error.path, error.problem, error.remedy)
        }])
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Error::Sources(problems) => {
                for problem in problems {
                    writeln!(f, "{problem}")?;
                }
                write!(f, "{} to mend", problems.len())
            }
            Error::Environment { problem, remedy } => write!(f, "{problem}\n  remedy: {remedy}"),
        }
    }
}

impl std::error::Error for Error {}
