//! Where the files of a checkout are.

use std::path::{Path, PathBuf};
use std::{env, fs};

use toml::Table;

use crate::error::{Error, Result, ResultExt};

/// The checkout the command works in.
#[derive(Clone, Debug)]
pub struct Checkout {
    root: PathBuf,
}

impl Checkout {
    /// The checkout in this folder. A test may use any folder.
    pub fn at(root: &Path) -> Checkout {
        Checkout { root: root.into() }
    }

    /// The checkout that this program was built from or, if that is gone, the one around the
    /// program's own file. The current folder doesn't count, because it may be a student's, with
    /// its own goldens and settings.
    pub fn find() -> Result<Checkout> {
        let program = env::current_exe().unwrap_or_default();
        let built_from = Path::new(env!("CARGO_MANIFEST_DIR"));
        Checkout::of(
            built_from.ancestors().nth(2).unwrap_or(built_from),
            &program,
        )
        .ok_or_else(|| {
            Error::environment(
                "the repository that this command was built in is gone",
                "run the command inside the repository: cargo pinhole …",
            )
        })
    }

    /// The checkout in the folder `built_from`, or around the file `program`.
    fn of(built_from: &Path, program: &Path) -> Option<Checkout> {
        let is_root = |folder: &&Path| {
            folder.join("assignments").is_dir() && folder.join("Cargo.lock").is_file()
        };
        let own = Some(built_from).filter(is_root);
        own.or_else(|| program.ancestors().find(is_root))
            .map(Checkout::at)
    }

    /// Its top folder.
    pub fn root(&self) -> &Path {
        &self.root
    }

    /// The folder of assignments.
    pub fn assignments(&self) -> PathBuf {
        self.root.join("assignments")
    }

    /// The assignment to use unless the user names another. The workspace's `Cargo.toml` names
    /// it.
    ///
    /// # Errors
    /// If `Cargo.toml` names no default assignment.
    pub fn default_assignment(&self) -> Result<String> {
        let path = self.root.join("Cargo.toml");
        let text = fs::read_to_string(&path).unwrap_or_default();
        let manifest: Option<Table> = text.parse().ok();
        let name = manifest.as_ref().and_then(|manifest| {
            let metadata = manifest.get("workspace")?.get("metadata")?;
            metadata.get("pinhole")?.get("default-assignment")?.as_str()
        });
        name.map(str::to_owned).ok_or_else(|| {
            Error::environment(
                format!("{} names no default assignment", path.display()),
                "name one with --assignment, or restore the file",
            )
        })
    }

    /// The folder of the book's sources.
    pub fn book(&self) -> PathBuf {
        self.root.join("book")
    }

    /// A folder for temporary files, which `cargo clean` deletes.
    pub fn scratch(&self) -> PathBuf {
        self.root.join("target").join("pinhole")
    }

    /// A file's path, relative to the top of the checkout if the file lies in it.
    pub fn inside(&self, path: &Path) -> PathBuf {
        path.strip_prefix(&self.root).unwrap_or(path).into()
    }

    /// The text of a file, named from the top of the checkout.
    pub fn read(&self, path: impl AsRef<Path>) -> Result<String> {
        let path = self.root.join(path);
        fs::read_to_string(&path).or_fail(&Error::file(&path))
    }

    /// Writes a file, named from the top of the checkout, and the folders it lies in.
    pub fn write(&self, path: impl AsRef<Path>, content: impl AsRef<[u8]>) -> Result<()> {
        let path = self.root.join(path);
        let folder = path.parent().unwrap_or(&path);
        fs::create_dir_all(folder)
            .and_then(|()| fs::write(&path, content))
            .or_fail(&Error::file(&path))
    }

    /// Whether a folder is in the checkout, by its path without links. The user trusts the code there
    /// in any case.
    pub fn contains(&self, folder: &Path) -> bool {
        let root = self.root.canonicalize();
        root.is_ok_and(|root| folder.starts_with(root))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_moved_program_finds_its_own_checkout_and_no_other() {
        let folder = tempfile::tempdir().unwrap();
        let own = folder.path().join("moved");
        fs::create_dir_all(own.join("assignments")).unwrap();
        fs::write(own.join("Cargo.lock"), "").unwrap();
        let gone = folder.path().join("gone");
        let found = Checkout::of(&gone, &own.join("target/release/pinhole")).unwrap();
        assert_eq!(found.root(), own);
        // The current folder is a checkout, too, but must not be found, because it could be a
        // student's.
        assert!(Checkout::of(&gone, &folder.path().join("pinhole")).is_none());
    }
}
