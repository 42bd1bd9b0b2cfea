//! What the real mistakes of a task look like: expected, theirs, and where they differ.
//!
//! Each mistake is compiled as a student's answers are, and casts the scene that shows it
//! best. The strips of three pictures are kept beside the chapters, so that building the
//! book needs none of that; the check makes them anew and compares.

mod cast;
mod kept;
mod made;
mod shown;
pub mod strip;

use serde::{Deserialize, Serialize};

use crate::checkout::Checkout;
use crate::error::{Problem, Result};
pub use shown::shown;

/// What is told of a strip.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub struct Told {
    /// The scene that was cast.
    pub scene: String,
    /// Which of the three pictures: `id`, `depth` or `normal`.
    pub picture: String,
    /// In how many pixels it differs.
    pub pixels: usize,
    /// Of how many.
    pub of: usize,
}

/// Makes strips, of all mistakes or of those named, and keeps them.
pub fn keep(slugs: &[String], checkout: &Checkout) -> Result<()> {
    kept::keep(made::made(slugs, checkout)?, checkout)
}

/// Strips that are not what their mistake casts.
pub fn check(checkout: &Checkout) -> Result<Vec<Problem>> {
    Ok(kept::stale(&made::made(&[], checkout)?, checkout))
}
