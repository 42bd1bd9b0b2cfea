//! Rules for the whole source: which package imports which ([`packages`]), which module imports
//! which ([`modules`]), what we may depend on ([`dependencies`]), that the tools take
//! assignments, tasks and shapes as data ([`names`]), and which of the documented commands are
//! run ([`commands`]).

mod commands;
mod dependencies;
mod modules;
mod names;
mod packages;

use std::fs;
use std::path::{Path, PathBuf};

/// Whether a file exists only for tests.
pub fn is_test(inside: &Path) -> bool {
    let test = ["tests", "tests.rs", "testing", "testing.rs"];
    inside.iter().any(|part| test.iter().any(|it| part == *it))
}

/// The Rust files in a folder and below.
pub fn sources(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).expect("it can be read").flatten() {
        let path = entry.path();
        match path.is_dir() {
            true => found.extend(sources(&path)),
            false => found.push(path),
        }
    }
    found.retain(|path| path.extension().is_some_and(|end| end == "rs"));
    found
}
