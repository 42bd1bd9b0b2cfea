//! The compiled harness that submissions are linked against.
//!
//! We call `rustc` with the library that cargo has already built, so compiling an edited answer
//! takes about 0.15 s. If every submission were a cargo package, each would compile the harness
//! again.

use std::fs;
use std::path::{Path, PathBuf};

use hmac_sha256::Hash;
use serde::{Deserialize, Serialize};

use crate::checkout::Checkout;
use crate::error::{Error, Result, ResultExt};
use crate::private::allow;
use crate::progress::patiently;
use crate::rust_tool::rust_tool;

/// A folder with the libraries a submission needs, and nothing else of ours.
#[derive(Clone, Debug, Deserialize, Serialize)]
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
    /// The libraries of this program's own build, in `scratch`. Asking cargo takes 0.2 s, so an
    /// earlier result is used again. That is safe, because anything that changes the harness
    /// changes this program too.
    pub fn find(checkout: &Checkout, scratch: &Path) -> Result<Harness> {
        let record = record_of_this_program(&scratch.join("harness"));
        let known = record.as_deref().and_then(Harness::read);
        if let Some(harness) = known {
            return Ok(harness);
        }
        let harness = Harness::gather(checkout, scratch)?;
        if let Some(record) = record {
            harness.write(&record);
        }
        Ok(harness)
    }

    /// The libraries in a record, if they still exist.
    fn read(record: &Path) -> Option<Harness> {
        let harness: Harness = serde_json::from_slice(&fs::read(record).ok()?).ok()?;
        let mut files = harness.externs.iter().map(|(_, file)| file);
        files.all(|file| file.is_file()).then_some(harness)
    }

    fn write(&self, record: &Path) {
        let new = record.with_extension(format!("new{}", std::process::id()));
        let written = serde_json::to_vec(self).map_err(std::io::Error::other);
        let written = written.and_then(|text| fs::write(&new, text));
        // If this fails, we ask cargo again next time.
        let _kept_or_not = written.and_then(|()| fs::rename(&new, record));
    }

    /// Asks cargo for the libraries, which it builds if needed, and gathers them in a folder of
    /// their own in `scratch`. Cargo's folder also holds the compiled reference.
    fn gather(checkout: &Checkout, scratch: &Path) -> Result<Harness> {
        let mut cargo = rust_tool("cargo", checkout.root());
        // Building `-p pinhole` alone would use other features. And the default members of a
        // student's repository include answers, which may not compile.
        cargo
            .args(["build", "--quiet", "--message-format=json"])
            .args(["-p", "pinhole", "-p", "pinhole-cli"]);
        if !cfg!(debug_assertions) {
            cargo.arg("--release");
        }
        let what = "building the harness that answers are compiled against";
        let output = patiently(what, &scratch.join("harness").join("seconds"), || {
            cargo.output()
        });
        let output = output.or_environment("cannot start cargo", "install Rust from rustup.rs")?;
        if !output.status.success() {
            return Err(Error::environment(
                format!(
                    "the harness does not build:\n{}",
                    String::from_utf8_lossy(&output.stderr)
                ),
                "run `cargo build --release` in the checkout and fix the errors it reports",
            ));
        }
        let mut libraries: Vec<(String, PathBuf)> = artifacts(&output.stdout).collect();
        // Cargo names them in an order that changes from run to run.
        libraries.sort();
        // Each state of the libraries gets its own folder: while one command compiles against
        // them, another may find that cargo has built new ones.
        let folder = scratch.join("harness").join(fingerprint(&libraries));
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

/// The file that records where the libraries of this build of the program are.
fn record_of_this_program(folder: &Path) -> Option<PathBuf> {
    let program = std::env::current_exe().ok()?;
    let metadata = fs::metadata(&program).ok()?;
    let build = (metadata.len(), metadata.modified().ok()?);
    let build = Hash::hash(format!("{}\n{build:?}", program.display()).as_bytes());
    Some(folder.join(format!("{}.json", hex::encode(&build[..8]))))
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

/// Whether cargo built a Rust library, or a procedural macro that a library refers to.
fn is_library(file: &Path) -> bool {
    let extension = file.extension().and_then(|extension| extension.to_str());
    matches!(extension, Some("rlib" | "so" | "dylib" | "dll"))
}

/// Identifies the state of the libraries by their names, lengths and times. The hash in
/// cargo's file names is not enough: some changes of content don't change it.
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
        format!("cannot copy the harness to {}", folder.display()),
        "free some disk space and check that you may write to the folder",
    );
    let fresh = folder.with_extension(format!("new{}", std::process::id()));
    fs::create_dir_all(&fresh).or_fail(&failed)?;
    for (_, library) in libraries {
        let copy = fresh.join(library.file_name().unwrap_or_default());
        // A link costs nothing and keeps the old content when cargo writes a new file.
        fs::hard_link(library, &copy)
            .or_else(|_| fs::copy(library, &copy).map(|_| ()))
            .and_then(|()| allow(&copy, 0o644))
            .or_fail(&failed)?;
    }
    let around = folder.parent().unwrap_or(folder);
    allow(&fresh, 0o755)
        .and_then(|()| allow(around, 0o711))
        .or_fail(&failed)?;
    match fs::rename(&fresh, folder) {
        // Another command has made the same folder in the meantime.
        Err(_) if folder.is_dir() => fs::remove_dir_all(&fresh).or_fail(&failed),
        renamed => renamed.or_fail(&failed),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn record_is_valid_while_its_libraries_exist() {
        let folder = tempfile::tempdir().unwrap();
        let library = folder.path().join("libpinhole-0.rlib");
        fs::write(&library, "").unwrap();
        let harness = Harness {
            folder: folder.path().to_owned(),
            externs: vec![("pinhole".into(), library.clone())],
        };
        let record = record_of_this_program(folder.path()).unwrap();
        assert!(Harness::read(&record).is_none());
        harness.write(&record);
        assert_eq!(Harness::read(&record).unwrap().externs, harness.externs);
        fs::remove_file(library).unwrap();
        assert!(Harness::read(&record).is_none());
        fs::write(&record, "{").unwrap();
        assert!(Harness::read(&record).is_none());
    }
}
