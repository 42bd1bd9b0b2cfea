//! `handout.toml`, the record of what `pinhole handout` wrote to a student's repository.
//!
//! It marks a student's repository, shows whether the stubs are unchanged, and lists
//! the files that a later handout may replace.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Component, Path, PathBuf};

use serde::{Deserialize, Serialize};

use crate::checkout::Checkout;
use crate::error::{Error, Result, ResultExt};
use crate::manifest::{self, Hashes};

/// Paths inside a folder, and the files' contents.
pub type Package = BTreeMap<PathBuf, String>;

/// The file's name, at the top.
pub const FILE: &str = "handout.toml";

/// The record of a student's repository as it was handed out.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
#[serde(deny_unknown_fields)]
pub struct HandoutRecord {
    /// The assignment's name.
    pub assignment: String,
    /// Every other file, relative to this one.
    pub files: Hashes,
}

impl HandoutRecord {
    /// The record of the repository at `root`; `None` if it is not a student's.
    pub fn read(root: &Path) -> Result<Option<HandoutRecord>> {
        let path = root.join(FILE);
        if !path.is_file() {
            return Ok(None);
        }
        let wrong = Error::input(
            path.display().to_string(),
            "restore the file: git checkout handout.toml",
        );
        let text = fs::read_to_string(&path).or_fail(&wrong)?;
        let record: HandoutRecord = toml::from_str(&text).or_fail(&wrong)?;
        // A later handout replaces and removes the files on this list.
        let is_inside = |path: &&String| {
            let mut parts = Path::new(path).components();
            parts.all(|part| matches!(part, Component::Normal(_)))
        };
        match record.files.keys().find(|path| !is_inside(path)) {
            Some(path) => Err(wrong.because(format!("{path} lies outside the repository"))),
            None => Ok(Some(record)),
        }
    }

    /// The text of the file.
    pub fn text(&self) -> Result<String> {
        let text = toml::to_string(self)
            .or_environment(format_args!("cannot write {FILE}"), "report this")?;
        let head = "# Written by `pinhole handout`: the files that are not yours to change.\n\n";
        Ok(format!("{head}{text}"))
    }

    /// The files of a folder, as they were handed out.
    ///
    /// # Errors
    /// If one of them has changed.
    pub fn package(&self, folder: &Path, checkout: &Checkout) -> Result<Package> {
        let inside = folder.strip_prefix(checkout.root()).unwrap_or(folder);
        let inside = inside.to_string_lossy().replace('\\', "/");
        let mut package = Package::new();
        for (path, recorded) in &self.files {
            let name = path.strip_prefix(&inside);
            let Some(name) = name.and_then(|name| name.strip_prefix('/')) else {
                continue;
            };
            let file = checkout.root().join(path);
            let text = fs::read_to_string(&file).ok();
            let is_as_it_came =
                |text: &String| manifest::hash_of(&file, text.clone().into()) == *recorded;
            let text = text.filter(is_as_it_came).ok_or_else(|| {
                Error::input(
                    format!("{path} has changed since it was handed out"),
                    format!("restore it: git checkout {path}"),
                )
            })?;
            package.insert(name.into(), text);
        }
        Ok(package)
    }
}
