//! Asking oiiotool about films that only exist in memory.

use std::fs;
use std::path::{Path, PathBuf};

use pinhole::Film;
use pinhole::oiiotool::Oiiotool;

use crate::checkout::Checkout;
use crate::error::{Error, Result};
use crate::mitsuba;

/// The second judge, with a place to lay films before it.
pub struct SecondJudge {
    tool: Oiiotool,
    film: PathBuf,
}

impl SecondJudge {
    /// The installed oiiotool.
    pub fn find(checkout: &Checkout) -> Result<SecondJudge> {
        let tool = Oiiotool::find(&mitsuba::environment(checkout)).ok_or_else(|| {
            Error::environment(
                "the second judge, oiiotool, is not installed",
                "install it with Mitsuba: cargo run --release -- golden setup",
            )
        })?;
        let folder = checkout.scratch().join("second-judge");
        fs::create_dir_all(&folder).map_err(|error| {
            Error::environment(
                format!("cannot make {}: {error}", folder.display()),
                "check that the checkout can be written",
            )
        })?;
        Ok(SecondJudge {
            tool,
            film: folder.join(format!("{}.exr", std::process::id())),
        })
    }

    /// Asks about `film`, of which the first judge says that it `passes`.
    ///
    /// # Errors
    /// If the two disagree: that is our fault, never the film's.
    pub fn confirm(&self, film: &Film, golden: &Path, passes: bool) -> Result<()> {
        film.write(&self.film)?;
        let second = self.tool.judge(golden, &self.film).map_err(|problem| {
            Error::environment(
                problem,
                "install oiiotool again: cargo run --release -- golden setup",
            )
        })?;
        if second.passes == passes {
            return Ok(());
        }
        let word = |passes: bool| if passes { "passes" } else { "fails" };
        Err(Error::environment(
            format!(
                "the two judges disagree on {}: {} in Rust, {} in oiiotool ({})",
                golden.display(),
                word(passes),
                word(second.passes),
                second.said
            ),
            "this is a fault of Pinhole's, not of the submission: report it",
        ))
    }
}

impl Drop for SecondJudge {
    fn drop(&mut self) {
        let _never_written = fs::remove_file(&self.film);
    }
}
