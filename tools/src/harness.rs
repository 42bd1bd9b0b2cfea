//! The compiled harness that submissions are linked against.
//!
//! Calling `rustc` with the library that cargo has already built makes one edit
//! visible in about 0.15 s; a cargo package of its own for every submission would
//! compile the harness anew.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use serde::Deserialize;

use crate::checkout::Checkout;
use crate::error::{Error, Result};

/// A folder with the libraries a submission needs, and nothing else of ours.
#[derive(Clone, Debug)]
pub struct Harness {
    /// The folder: `-L dependency=`.
    pub folder: PathBuf,
    /// The crates a submission may name: name and file.
    pub externs: Vec<(String, PathBuf)>,
}

/// The crates that answers may use.
const EXTERNS: [&str; 2] = ["pinhole", "glam"];

#[derive(Deserialize)]
struct Artifact {
    reason: String,
    target: Option<Target>,
    #[serde(default)]
    filenames: Vec<PathBuf>,
}

#[derive(Deserialize)]
struct Target {
    name: String,
    kind: Vec<String>,
}

impl Harness {
    /// Asks cargo for the libraries (it builds them if needed) and gathers them in a
    /// folder of their own: cargo's holds the compiled reference as well.
    pub fn gather(checkout: &Checkout) -> Result<Harness> {
        let mut cargo = Command::new(std::env::var_os("CARGO").unwrap_or("cargo".into()));
        // The default members, not `-p pinhole`: alone it would be built with other features.
        cargo
            .current_dir(checkout.root())
            .args(["build", "--quiet", "--message-format=json"]);
        if !cfg!(debug_assertions) {
            cargo.arg("--release");
        }
        let output = cargo.output().map_err(|error| {
            Error::environment(
                format!("cannot start cargo: {error}"),
                "install Rust from rustup.rs",
            )
        })?;
        if !output.status.success() {
            return Err(Error::environment(
                format!(
                    "the harness does not build:\n{}",
                    String::from_utf8_lossy(&output.stderr)
                ),
                "run `cargo build --release` in the checkout and mend what it says",
            ));
        }
        let folder = checkout.scratch().join("harness");
        let mut externs = Vec::new();
        for artifact in artifacts(&output.stdout) {
            let Some(target) = &artifact.target else {
                continue;
            };
            for library in artifact.filenames.iter().filter(|file| is_library(file)) {
                let name = library.file_name().unwrap_or_default();
                let copy = folder.join(name);
                link(library, &copy)?;
                let is_rlib = copy
                    .extension()
                    .is_some_and(|extension| extension == "rlib");
                if is_rlib && EXTERNS.contains(&target.name.as_str()) {
                    externs.push((target.name.clone(), copy));
                }
            }
        }
        if externs.len() != EXTERNS.len() {
            return Err(Error::environment(
                "cargo did not say where the harness library is",
                "run `cargo clean`, then this command again",
            ));
        }
        Ok(Harness { folder, externs })
    }
}

fn artifacts(stdout: &[u8]) -> impl Iterator<Item = Artifact> + '_ {
    stdout
        .split(|byte| *byte == b'\n')
        .filter_map(|line| serde_json::from_slice::<Artifact>(line).ok())
        .filter(|artifact| artifact.reason == "compiler-artifact")
        .filter(|artifact| {
            let library = |kind: &String| kind.ends_with("lib") || kind == "proc-macro";
            artifact
                .target
                .as_ref()
                .is_some_and(|target| target.kind.iter().any(library))
        })
}

/// Rust libraries and, since they name them, the procedural macros they used.
fn is_library(file: &Path) -> bool {
    let extension = file.extension().and_then(|extension| extension.to_str());
    matches!(extension, Some("rlib" | "so" | "dylib" | "dll"))
}

fn link(from: &Path, to: &Path) -> Result<()> {
    let failed = |error: std::io::Error| {
        Error::environment(
            format!(
                "cannot copy {} to {}: {error}",
                from.display(),
                to.display()
            ),
            "free some disk space and check that the folder can be written",
        )
    };
    // File names carry cargo's hash, but not every change of content changes it.
    let same = |a: &Path, b: &Path| -> std::io::Result<bool> {
        let (a, b) = (fs::metadata(a)?, fs::metadata(b)?);
        Ok(a.len() == b.len() && a.modified()? <= b.modified()?)
    };
    if same(from, to).unwrap_or(false) {
        return Ok(());
    }
    fs::create_dir_all(to.parent().unwrap_or(to)).map_err(failed)?;
    // Under another name first: a second command may be reading the old one.
    let fresh = to.with_extension(format!("new{}", std::process::id()));
    fs::copy(from, &fresh).map_err(failed)?;
    fs::rename(&fresh, to).map_err(failed)
}
