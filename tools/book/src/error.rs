//! Errors in the book, or on the machine that builds it.

use std::fmt;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// Something in the book that is wrong, and what to do about it.
#[derive(Clone, Debug, PartialEq)]
pub struct Problem {
    /// The file, from the top of the checkout.
    pub file: PathBuf,
    /// The line, counted from 1, if there is one.
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

/// Why the book could not be built.
#[derive(Debug)]
pub enum Error {
    /// Its sources have these problems.
    Sources(Vec<Problem>),
    /// Something that the book needs is missing or broken: a file, the machine, or this program.
    Course(pinhole_course::error::Error),
}

/// A problem and its remedy, from code that doesn't know the page and the line.
pub type ProblemAndRemedy = (String, String);

/// The result of everything in this package that can fail.
pub type Result<T> = std::result::Result<T, Error>;

impl Error {
    /// Something is missing or broken that can't be corrected in a page.
    pub fn environment(problem: impl Into<String>, remedy: impl Into<String>) -> Error {
        pinhole_course::error::Error::environment(problem, remedy).into()
    }

    /// A file cannot be read or written.
    pub fn file(path: &Path, error: &dyn fmt::Display) -> Error {
        pinhole_course::error::Error::file(path)
            .because(error.to_string())
            .into()
    }

    /// 2 if the book's sources are wrong, 3 for any other fault.
    pub fn exit_code(&self) -> ExitCode {
        match self {
            Error::Sources(_) => ExitCode::from(2),
            Error::Course(error) => error.exit_code(),
        }
    }
}

impl From<Problem> for Error {
    fn from(problem: Problem) -> Error {
        Error::Sources(vec![problem])
    }
}

impl From<pinhole_course::error::Error> for Error {
    fn from(error: pinhole_course::error::Error) -> Error {
        Error::Course(error)
    }
}

impl From<pinhole::Error> for Error {
    fn from(error: pinhole::Error) -> Error {
        Error::Course(error.into())
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Error::Sources(problems) => {
                for problem in problems {
                    writeln!(f, "{problem}")?;
                }
                write!(f, "problems to correct: {}", problems.len())
            }
            Error::Course(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for Error {}
