//! The compiled harness that submissions are linked against.
//!
//! Calling `rustc` with the library that cargo has already built makes one edit
//! visible in about 0.15 s; a cargo package of its own for every submission would
//! compile the harness anew.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use hmac_sha256::Hash;
use serde::Deserialize;

use crate::checkout::Checkout;
use crate::error::{Error, Result, ResultExt};

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

#[derive(Default, Deserialize)]
struct Target {
    name: String,
    kind: Vec<String>,
}

impl Harness {
    /// Asks cargo for the libraries (it builds them if needed) and gathers them in a
    /// folder of their own: cargo's holds the compiled reference as well.
    pub fn gather(checkout: &Checkout) -> Result<Harness> {
        let mut cargo = Command::new(std::env::var_os("CARGO").unwrap_or("cargo".into()));
        // Not `-p pinhole` alone: it would be built with other features. And not the default
        // members: in a student's repository, answers that may not compile are among them.
        cargo
            .current_dir(checkout.root())
            .args(["build", "--quiet", "--message-format=json"])
            .args(["-p", "pinhole", "-p", "pinhole-cli"]);
        if !cfg!(debug_assertions) {
            cargo.arg("--release");
        }
        let output = cargo
            .output()
            .or_environment("cannot start cargo", "install Rust from rustup.rs")?;
        if !output.status.success() {
            return Err(Error::environment(
                format!(
                    "the harness does not build:\n{}",
                    String::from_utf8_lossy(&output.stderr)
                ),
                "run `cargo build --release` in the checkout and mend what it says",
            ));
        }
        let mut libraries: Vec<(String, PathBuf)> = artifacts(&output.stdout).collect();
        // Cargo names them in whatever order its threads come by them.
        libraries.sort();
        // A folder for each state of the libraries: while one command compiles against
        // them, another may find that cargo has built new ones.
        let folder = checkout
            .scratch()
            .join("harness")
            .join(fingerprint(&libraries));
        if !folder.is_dir() {
            fill(&folder, &libraries)?;
        }
        let externs = libraries.iter().filter(|(name, file)| {
            EXTERNS.contains(&name.as_str()) && file.extension().is_some_and(|end| end == "rlib")
        });
        let externs: Vec<(String, PathBuf)> = externs
            .map(|(name, file)| {
                (
                    name.clone(),
                    folder.join(file.file_name().unwrap_or_default()),
                )
            })
            .collect();
        if externs.len() != EXTERNS.len() {
            return Err(Error::environment(
                "cargo did not say where the harness library is",
                "run `cargo clean`, then this command again",
            ));
        }
        Ok(Harness { folder, externs })
    }
}

/// The libraries that cargo names in its messages: crate and file.
fn artifacts(stdout: &[u8]) -> impl Iterator<Item = (String, PathBuf)> + '_ {
    let messages = stdout.split(|byte| *byte == b'\n');
    let artifacts = messages.filter_map(|line| serde_json::from_slice::<Artifact>(line).ok());
    artifacts
        .filter(|artifact| artifact.reason == "compiler-artifact")
        .flat_map(|artifact| {
            let target = artifact.target.unwrap_or_default();
            let library = |kind: &String| kind.ends_with("lib") || kind == "proc-macro";
            let wanted = target.kind.iter().any(library);
            let files = artifact
                .filenames
                .into_iter()
                .filter(move |file| wanted && is_library(file));
            files.map(move |file| (target.name.clone(), file))
        })
}

/// Rust libraries and, since they name them, the procedural macros they used.
fn is_library(file: &Path) -> bool {
    let extension = file.extension().and_then(|extension| extension.to_str());
    matches!(extension, Some("rlib" | "so" | "dylib" | "dll"))
}

/// Cargo's file names carry a hash, but not every change of content changes it.
fn fingerprint(libraries: &[(String, PathBuf)]) -> String {
    let mut hash = Hash::new();
    for (_, file) in libraries {
        let metadata = fs::metadata(file);
        let state = metadata.map(|metadata| (metadata.len(), metadata.modified().ok()));
        hash.update(format!("{}\n{state:?}\n", file.display()));
    }
    hex::encode(&hash.finalize()[..8])
}

/// Links the libraries into a folder that appears only when it is complete.
fn fill(folder: &Path, libraries: &[(String, PathBuf)]) -> Result<()> {
    let failed = Error::environment(
        format!("cannot gather the harness in {}", folder.display()),
        "free some disk space and check that the folder can be written",
    );
    let fresh = folder.with_extension(format!("new{}", std::process::id()));
    fs::create_dir_all(&fresh).or_fail(&failed)?;
    for (_, library) in libraries {
        let copy = fresh.join(library.file_name().unwrap_or_default());
        // A link costs nothing and keeps the old content when cargo writes a new file.
        fs::hard_link(library, &copy)
            .or_else(|_| fs::copy(library, &copy).map(|_| ()))
            .or_fail(&failed)?;
    }
    match fs::rename(&fresh, folder) {
        // Another command was quicker with the same.
        Err(_) if folder.is_dir() => fs::remove_dir_all(&fresh).or_fail(&failed),
        renamed => renamed.or_fail(&failed),
    }
}
