//! Where things lie in a checkout of this repository.

use std::fs;
use std::path::{Path, PathBuf};

use crate::error::{Error, Result};

/// The checkout whose book is built.
#[derive(Clone, Debug)]
pub struct Checkout {
    root: PathBuf,
}

impl Checkout {
    /// The checkout this program was built from.
    pub fn find() -> Result<Checkout> {
        let built_from = Path::new(env!("CARGO_MANIFEST_DIR"));
        match built_from.ancestors().nth(2) {
            Some(root) if root.join("book/book.toml").is_file() => Ok(Checkout::at(root)),
            _ => Err(Error::environment(
                "the checkout this program was built from is gone",
                "run it inside a checkout: cargo run --release -- book build",
            )),
        }
    }

    /// The checkout, or what stands in for one in a test, in this folder.
    pub fn at(root: &Path) -> Checkout {
        Checkout { root: root.into() }
    }

    /// Its top folder.
    pub fn root(&self) -> &Path {
        &self.root
    }

    /// Where the book's sources lie.
    pub fn book(&self) -> PathBuf {
        self.root.join("book")
    }

    /// Where the assignment lies that the book explains.
    pub fn assignment(&self) -> PathBuf {
        self.root.join("assignments/ray_casting")
    }

    /// Where its golden films lie.
    pub fn golden(&self) -> PathBuf {
        self.root.join("golden/ray_casting")
    }

    /// Scratch space that `cargo clean` sweeps away.
    pub fn scratch(&self) -> PathBuf {
        self.root.join("target/pinhole/book")
    }

    /// A file's path as a reader of the repository writes it.
    pub fn inside(&self, path: &Path) -> PathBuf {
        path.strip_prefix(&self.root).unwrap_or(path).into()
    }

    /// The text of a file, named from the top of the checkout.
    pub fn read(&self, path: impl AsRef<Path>) -> Result<String> {
        let path = self.root.join(path);
        fs::read_to_string(&path).map_err(|error| Error::file(&path, &error))
    }
}

/// Writes a file and the folders it lies in.
pub fn write(path: &Path, content: impl AsRef<[u8]>) -> Result<()> {
    let folder = path.parent().unwrap_or(path);
    fs::create_dir_all(folder)
        .and_then(|()| fs::write(path, content))
        .map_err(|error| Error::file(path, &error))
}
