//! Where things lie in a checkout of this repository.

use std::env;
use std::path::{Path, PathBuf};

use crate::error::{Error, Result};

/// The checkout the command works in.
#[derive(Clone, Debug)]
pub struct Checkout {
    root: PathBuf,
}

impl Checkout {
    /// The checkout this program was built from, or else the one around the current
    /// folder: another checkout, a student's say, must not bring its own goldens.
    pub fn find() -> Result<Checkout> {
        let here = env::current_dir().unwrap_or_default();
        let built_from = Path::new(env!("CARGO_MANIFEST_DIR"));
        let is_root = |folder: &&Path| {
            folder.join("assignments").is_dir() && folder.join("Cargo.lock").is_file()
        };
        let own = built_from.ancestors().nth(2).filter(is_root);
        own.or_else(|| here.ancestors().find(is_root))
            .map(|root| Checkout { root: root.into() })
            .ok_or_else(|| {
                Error::environment(
                    "this is no checkout of Pinhole, and the one the command was built from is gone",
                    "run the command inside the checkout: cargo run --release -- …",
                )
            })
    }

    /// Its top folder.
    pub fn root(&self) -> &Path {
        &self.root
    }

    /// Where assignments lie.
    pub fn assignments(&self) -> PathBuf {
        self.root.join("assignments")
    }

    /// Where an assignment's golden films lie.
    pub fn golden(&self, assignment: &str) -> PathBuf {
        self.root.join("golden").join(assignment)
    }

    /// Scratch space that `cargo clean` sweeps away.
    pub fn scratch(&self) -> PathBuf {
        self.root.join("target").join("pinhole")
    }

    /// Whether a folder belongs to the checkout, whose code its user trusts anyway.
    pub fn contains(&self, folder: &Path) -> bool {
        match (folder.canonicalize(), self.root.canonicalize()) {
            (Ok(folder), Ok(root)) => folder.starts_with(root),
            _ => false,
        }
    }
}
