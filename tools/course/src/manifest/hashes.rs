//! Hashes of the files that goldens are made from, and the names they are recorded under.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use hmac_sha256::Hash;

use crate::assignment::Assignment;
use crate::error::{Result, ResultExt};
use crate::mistake;

/// SHA-256 of files, in hexadecimal, by path.
pub type Hashes = BTreeMap<String, String>;

/// The hash of a file.
pub fn hash(path: &Path) -> Result<String> {
    let bytes = fs::read(path).or_input(
        format_args!("cannot read {}", path.display()),
        "restore the file",
    )?;
    Ok(hash_of(path, bytes))
}

/// The hash of a scene or a mesh. A scene's hash covers its content but not its comments and
/// layout, so that changing those makes no film stale.
pub(super) fn source_hash(path: &Path) -> Result<String> {
    let scene = path
        .extension()
        .is_some_and(|extension| extension == "toml");
    let text = fs::read_to_string(path).ok().filter(|_| scene);
    match text.and_then(|text| text.parse::<toml::Table>().ok()) {
        Some(table) => Ok(hash_of(path, table.to_string().into())),
        None => hash(path),
    }
}

/// The hash of a file's content. Text is hashed with `\n` line ends, because git may check it out
/// with others.
pub fn hash_of(path: &Path, mut bytes: Vec<u8>) -> String {
    let is_picture = path.extension().is_some_and(|extension| extension == "png");
    if !is_film(path) && !is_picture {
        bytes.retain(|byte| *byte != b'\r');
    }
    hex::encode(Hash::hash(&bytes))
}

/// The hashes of the answer files and texts of every mistake that is fingerprinted.
pub(super) fn mistake_hashes(assignment: &Assignment) -> Result<Hashes> {
    let mut hashes = Hashes::new();
    for mistake in mistake::read_all(assignment)? {
        let entries = fs::read_dir(&mistake.folder)
            .into_iter()
            .flatten()
            .flatten();
        let files = entries
            .map(|entry| entry.path())
            .filter(|path| path.is_file());
        for file in files.filter(|_| mistake.mistake.is_single()) {
            hashes.insert(
                relative(&file, assignment.course(), assignment),
                hash(&file)?,
            );
        }
    }
    Ok(hashes)
}

pub(super) fn is_film(path: &Path) -> bool {
    path.extension().is_some_and(|extension| extension == "exr")
}

pub(super) fn relative(path: &Path, folder: &Path, assignment: &Assignment) -> String {
    let absolute = path.canonicalize().unwrap_or(path.into());
    let within = |root: &Path| {
        let root = root.canonicalize().ok()?;
        absolute.strip_prefix(root).ok().map(slashed)
    };
    within(folder)
        .or_else(|| within(assignment.course()))
        .unwrap_or_else(|| slashed(&absolute))
}

pub(super) fn slashed(path: &Path) -> String {
    path.to_string_lossy().replace('\\', "/")
}
