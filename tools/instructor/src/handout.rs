//! Makes a repository for students, with everything they need and none of our answers.
//!
//! Reading order: [`course`] selects the parts of the assignment to hand out, [`workspace`] the
//! packages around it, and [`readme`] writes the README. Then [`leak`] refuses anything that must
//! not be handed out, and [`place`] writes the repository, with a record by which later commands
//! recognise it.

mod course;
mod gradescope;
mod leak;
mod place;
mod prairielearn;
mod readme;
mod sources;
mod workspace;

use std::collections::BTreeMap;
use std::path::Path;
use std::process::Command;

use pinhole_course::assignment::Assignment;
use pinhole_course::checkout::Checkout;
use pinhole_course::error::{Error, Result, ResultExt};
use pinhole_course::rust_tool::rust_tool;

pub use gradescope::write as write_gradescope;
pub use place::HandoutSize;
pub use prairielearn::write as write_prairielearn;
use workspace::Workspace;

/// Settings for a student's editor and for GitHub, with their paths.
const SETTINGS: [(&str, &str); 6] = [
    (
        ".github/workflows/check.yml",
        include_str!("../templates/handout/check.yml"),
    ),
    (
        ".devcontainer/devcontainer.json",
        include_str!("../templates/handout/devcontainer.json"),
    ),
    (
        ".vscode/extensions.json",
        include_str!("../templates/handout/extensions.json"),
    ),
    (
        ".vscode/settings.json",
        include_str!("../templates/handout/settings.json"),
    ),
    (
        ".vscode/tasks.json",
        include_str!("../templates/handout/tasks.json"),
    ),
    (
        "rust-analyzer.toml",
        include_str!("../templates/handout/rust-analyzer.toml"),
    ),
];

/// Cargo's settings.
const CARGO_CONFIG: &str = ".cargo/config.toml";

/// The settings that `cargo vendor` asks for.
const VENDORED: &str = r#"
# All dependencies are in this repository, so it builds without a network.
[source.crates-io]
replace-with = "vendored-sources"

[source.vendored-sources]
directory = "vendor"
"#;

/// A command of cargo for the workspace in `repository`, whose path is absolute. Cargo obeys settings
/// in the folders around the one where it starts. Other users may have put some around `repository`,
/// so it starts in the checkout.
fn cargo_on(repository: &Path, checkout: &Checkout, command: &str) -> Command {
    let mut cargo = rust_tool("cargo", checkout.root());
    let manifest = repository.join("Cargo.toml");
    cargo.args([command, "--quiet", "--manifest-path"]);
    cargo.arg(manifest);
    cargo
}

/// Adds the sources of all dependencies to a repository that has been written. Downloads those that
/// cargo has no copy of.
pub fn vendor(repository: &Path, checkout: &Checkout) -> Result<()> {
    let repository = &repository
        .canonicalize()
        .or_fail(&Error::file(repository))?;
    let output = cargo_on(repository, checkout, "vendor")
        .arg("--locked")
        .arg(repository.join("vendor"))
        .output()
        .or_environment("cannot run cargo", "install Rust from https://rustup.rs")?;
    match output.status.success() {
        true => Ok(()),
        false => Err(Error::environment(
            format!("cargo vendor: {}", String::from_utf8_lossy(&output.stderr)),
            "run this command once with a network, so that cargo can download all dependencies",
        )),
    }
}

/// The contents of files, by path from the top of a repository, with `/` on every system.
pub type Files = BTreeMap<String, Vec<u8>>;

/// An assignment's folder in the handed-out repository, wherever the assignment is in this
/// checkout.
fn place_of(assignment: &Assignment) -> String {
    format!("assignments/{}", assignment.name)
}

/// A student's repository before it is written.
pub struct Repository {
    assignment: String,
    files: Files,
    /// Whether cargo looks for dependencies in the folder that [`vendor`] fills.
    pub vendored: bool,
}

impl Repository {
    /// The repository of an assignment.
    ///
    /// `book` is a folder with the book that was built for students.
    ///
    /// # Errors
    /// If a file contains something that must not be handed out.
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
            // `cargo test` tests the answers. `cargo run` is the `pinhole` command, because only
            // its package names a program to run.
            default: &packages,
        };
        workspace.add(&mut files, checkout)?;
        files.extend(SETTINGS.map(|(path, text)| (path.into(), text.into())));
        if let Some(folder) = book {
            sources::add_folder_as(&mut files, folder, "book", &[])?;
        }
        files.extend(course::files(assignment)?);
        readme::adapt(&mut files, assignment, checkout)?;
        leak::refuse(&files, assignment)?;
        Ok(Repository {
            assignment: assignment.name.clone(),
            files,
            vendored: false,
        })
    }

    /// Writes it to `out`, completely or not at all.
    pub fn write(self, out: &Path, checkout: &Checkout, force: bool) -> Result<HandoutSize> {
        place::write(self, out, checkout, force)
    }
}
