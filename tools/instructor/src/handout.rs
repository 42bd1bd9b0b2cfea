//! A repository for students: everything to work with, and nothing to copy from.
//!
//! Reading order: [`course`] for what of the assignment travels, [`workspace`] for what
//! builds around it, [`readme`]; then [`leak`], which refuses what must not travel, and
//! [`place`], which writes it with a record by which it is known again.

mod course;
mod gradescope;
mod leak;
mod place;
mod readme;
mod sources;
mod workspace;

use std::collections::BTreeMap;
use std::path::Path;

use pinhole_course::assignment::Assignment;
use pinhole_course::checkout::Checkout;
use pinhole_course::error::Result;

pub use gradescope::write as write_gradescope;
pub use place::Written;
use workspace::Workspace;

/// The workflow for GitHub, and where it lies.
const WORKFLOW: &str = ".github/workflows/check.yml";
const CHECK: &str = include_str!("../templates/handout/check.yml");

/// What files hold, by path from the top of a repository, with `/` on every system.
pub type Files = BTreeMap<String, Vec<u8>>;

/// An assignment's folder in what is handed out, wherever it lies here.
fn place_of(assignment: &Assignment) -> String {
    format!("assignments/{}", assignment.name)
}

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
        let mut files = Files::new();
        sources::add_top(&mut files, checkout)?;
        let answers = format!("{}/handout", place_of(assignment));
        let packages = [answers, workspace::CLI.to_owned()];
        let workspace = Workspace {
            assignment,
            packages: &packages,
            // `cargo test` tests the answers; `cargo run` is the `pinhole` command, since
            // only its package names a program to run.
            default: &packages,
        };
        workspace.add(&mut files, checkout)?;
        files.insert(WORKFLOW.into(), CHECK.into());
        if let Some(folder) = book {
            sources::add_folder_as(&mut files, folder, "book", &[])?;
        }
        files.extend(course::files(assignment)?);
        readme::adapt(&mut files, assignment, checkout)?;
        leak::refuse(&files, assignment)?;
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
