//! The assignments that the book explains.

use pinhole::Kind;
use pinhole_course::assignment::Assignment;
use pinhole_course::checkout::Checkout;
use std::path::PathBuf;

use crate::error::{Error, Result};

/// The assignment from whose scenes most figures and numbers come.
const NAME: &str = "ray_casting";

/// Reads that assignment.
pub fn assignment(checkout: &Checkout) -> Result<Assignment> {
    Ok(Assignment::read(checkout, NAME)?)
}

/// Reads all assignments. No two of them have a task or a mistake of the same name.
pub fn assignments(checkout: &Checkout) -> Result<Vec<Assignment>> {
    Ok(Assignment::read_all(checkout)?)
}

/// Reads the assignment with a task of this kind.
pub fn assignment_with(kind: Kind, checkout: &Checkout) -> Result<Assignment> {
    let mut all = assignments(checkout)?.into_iter();
    let found = all.find(|assignment| assignment.task_of_kind(kind, None).is_some());
    found.ok_or_else(|| {
        let problem = format!("no assignment has a task of the kind `{kind}`");
        Error::environment(problem, "restore the folder of assignments")
    })
}

/// The folder of the first assignment's golden films.
pub fn golden(checkout: &Checkout) -> PathBuf {
    checkout.root().join("golden").join(NAME)
}

/// The book's folder for temporary files.
pub fn scratch(checkout: &Checkout) -> PathBuf {
    checkout.scratch().join("book")
}
