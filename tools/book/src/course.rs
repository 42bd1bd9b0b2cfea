//! The assignment that the book explains.

use pinhole_course::assignment::Assignment;
use pinhole_course::checkout::Checkout;
use std::path::PathBuf;

use crate::error::Result;

/// Its name.
const NAME: &str = "ray_casting";

/// Reads it.
pub fn assignment(checkout: &Checkout) -> Result<Assignment> {
    Ok(Assignment::read(checkout, NAME)?)
}

/// Where its golden films lie.
pub fn golden(checkout: &Checkout) -> PathBuf {
    checkout.root().join("golden").join(NAME)
}

/// Scratch space of the book's own.
pub fn scratch(checkout: &Checkout) -> PathBuf {
    checkout.scratch().join("book")
}
