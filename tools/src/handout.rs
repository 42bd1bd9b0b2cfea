//! A repository for students: everything to work with, and nothing to copy from.
//!
//! Reading order: [`course`] for what of the assignment travels, [`workspace`] for what
//! builds around it, [`readme`]; then [`leak`], which refuses what must not travel, and
//! [`place`], which writes it, and [`record`], by which it is known again.

pub mod record;

mod course;
mod gradescope;
mod leak;
mod place;
mod readme;
mod sources;
mod tables;
mod workspace;

use std::collections::BTreeMap;
use std::path::Path;

use crate::assignment::{Assignment, ScenePoints};
use crate::checkout::Checkout;
use crate::error::Result;

pub use gradescope::write as write_gradescope;
pub use place::Written;

/// What files hold, by path from the top of a repository, with `/` on every system.
pub type Files = BTreeMap<String, Vec<u8>>;

/// A student's repository before it is written.
pub struct Repository {
    assignment: String,
    files: Files,
}

impl Repository {
    /// The repository of an assignment.
    ///
    /// `book` is a folder with the book that was built for students.
    ///
    /// # Errors
    /// If something that must not travel would.
    pub fn of(
        assignment: &Assignment,
        checkout: &Checkout,
        book: Option<&Path>,
    ) -> Result<Repository> {
        let mut files = sources::shared(checkout)?;
        if let Some(folder) = book {
            sources::add_folder_as(&mut files, folder, "book", &[])?;
        }
        files.extend(course::files(assignment, checkout)?);
        workspace::adapt(&mut files, assignment)?;
        readme::adapt(&mut files, assignment)?;
        leak::refuse(&files, assignment, checkout)?;
        Ok(Repository {
            assignment: assignment.name.clone(),
            files,
        })
    }

    /// Writes it to `out`: whole, or not at all.
    pub fn write(self, out: &Path, force: bool) -> Result<Written> {
        place::write(self, out, force)
    }
}

impl Assignment {
    /// The scenes that students do not get.
    pub fn withheld_scenes(&self) -> impl Iterator<Item = &ScenePoints> {
        self.scenes.iter().filter(|scene| !scene.public)
    }

    /// Whether a film, by its name without `.exr`, or a file of it shows a withheld scene.
    fn withholds(&self, film: &str) -> bool {
        let scene = film.split('.').next().unwrap_or(film);
        self.withheld_scenes()
            .any(|withheld| withheld.name == scene)
    }
}
