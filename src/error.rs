//! The one error of the harness: what went wrong, where, and what to do.

use std::fmt;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// A file the harness cannot use. It names the file, the place and the remedy.
#[derive(Debug)]
pub struct Error {
    /// The file, as the caller named it.
    pub path: PathBuf,
    /// Line and column, both from 1, where the problem has a place.
    pub position: Option<(usize, usize)>,
    /// What is wrong, one sentence without a full stop.
    pub problem: String,
    /// What to do about it.
    pub remedy: String,
}

impl Error {
    /// A problem with a whole file.
    pub fn new(path: &Path, problem: impl Into<String>, remedy: impl Into<String>) -> Error {
        Error {
            path: path.into(),
            position: None,
            problem: problem.into(),
            remedy: remedy.into(),
        }
    }

    /// This error, at a line and column.
    pub fn at(self, line: usize, column: usize) -> Error {
        Error {
            position: Some((line, column)),
            ..self
        }
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.path.display())?;
        if let Some((line, column)) = self.position {
            write!(f, ":{line}:{column}")?;
        }
        write!(f, ": {}\n  remedy: {}", self.problem, self.remedy)
    }
}

impl std::error::Error for Error {}

/// The text of a file. Refuses pipes and devices, because reading one might never end.
pub(crate) fn read_text(path: &Path) -> io::Result<String> {
    if fs::metadata(path)?.is_file() {
        fs::read_to_string(path)
    } else {
        Err(io::Error::other("it is not a regular file"))
    }
}
