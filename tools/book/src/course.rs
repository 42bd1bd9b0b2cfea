//! The assignment as the book needs it: its tasks, and the mistakes people make.

use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;

use serde::Deserialize;

use crate::checkout::Checkout;
use crate::error::{Error, Problem, Result};

/// One of the assignment's tasks.
#[derive(Clone, Debug, Deserialize)]
pub struct Task {
    /// As everywhere: file, type and command-line word.
    pub name: String,
    /// The title of the chapter that explains it.
    pub chapter: String,
}

/// A scene's name.
#[derive(Clone, Debug, Deserialize)]
pub struct SceneName {
    /// Of the scene file and of its golden.
    pub name: String,
}

/// `assignment.toml`, as far as the book reads it.
#[derive(Clone, Debug, Deserialize)]
pub struct Course {
    /// In the assignment's order.
    pub task: Vec<Task>,
    /// In the assignment's order.
    pub scene: Vec<SceneName>,
}

/// `mistake.toml`, as far as the book reads it.
#[derive(Clone, Debug, Deserialize)]
pub struct Mistake {
    /// In a student's words.
    pub belief: String,
    /// The tasks it spoils.
    pub fails: Vec<String>,
    /// How many of the 115 public solutions that were looked at made it.
    pub submissions: Option<u32>,
    /// The chapter that helps.
    pub chapter: String,
    /// The single mistakes it is made of, if more than one.
    #[serde(default)]
    pub beliefs: Vec<String>,
    /// What helps.
    pub hint: Hint,
}

/// The part of a mistake's help that the book answers for.
#[derive(Clone, Debug, Deserialize)]
pub struct Hint {
    /// What to think about.
    pub think: String,
    /// The section to read.
    pub read: String,
}

/// In how many public solutions mistakes were counted.
pub const SOLUTIONS_COUNTED: u32 = 115;

impl Course {
    /// Reads it.
    pub fn read(checkout: &Checkout) -> Result<Course> {
        let path = checkout.assignment().join("assignment.toml");
        parse(checkout, path)
    }

    /// The task of this name.
    pub fn task(&self, name: &str) -> Option<&Task> {
        self.task.iter().find(|task| task.name == name)
    }
}

/// All mistakes by folder name.
pub fn mistakes(checkout: &Checkout) -> Result<BTreeMap<String, Mistake>> {
    let folder = checkout.assignment().join("mistakes");
    let entries = fs::read_dir(&folder).map_err(|error| Error::file(&folder, &error))?;
    let slugs = entries.flatten().filter(|entry| entry.path().is_dir());
    slugs
        .map(|entry| {
            let slug = entry.file_name().to_string_lossy().into_owned();
            let mistake = parse(checkout, entry.path().join("mistake.toml"))?;
            Ok((slug, mistake))
        })
        .collect()
}

fn parse<T: serde::de::DeserializeOwned>(checkout: &Checkout, path: PathBuf) -> Result<T> {
    toml::from_str(&checkout.read(&path)?).map_err(|error| {
        let remedy = "correct the file; those beside it show how";
        Problem::of(checkout.inside(&path), error.message(), remedy).into()
    })
}
