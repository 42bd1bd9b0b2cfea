//! A submission as it comes from a student: six named files, and nothing else.

use std::fs;
use std::path::{Path, PathBuf};

use crate::assignment::Assignment;
use crate::error::{Error, Result};

/// An answer file longer than this is refused.
const MOST_BYTES: u64 = 256 * 1024;

/// The answers found in a folder.
#[derive(Clone, Debug)]
pub struct Submission {
    /// The folder as the user named it.
    pub folder: PathBuf,
    /// Where in it the answer files lie.
    pub place: PathBuf,
    /// One for each task, in the assignment's order.
    pub answers: Vec<Answer>,
}

/// One task's answer file.
#[derive(Clone, Debug, PartialEq)]
pub struct Answer {
    /// The task, which is also the file's name without `.rs`.
    pub task: String,
    /// Its text, or why there is none.
    pub text: std::result::Result<String, Unusable>,
}

/// Why an answer file does not count.
#[derive(Clone, Debug, PartialEq)]
pub enum Unusable {
    /// It is not there.
    Missing,
    /// It is no regular UTF-8 file of ordinary size; why, in words.
    Refused(String),
}

impl Submission {
    /// Finds the answer files of `assignment` in `folder`, in its `src`, or in the
    /// same two places of the only folder inside.
    pub fn find(folder: &Path, assignment: &Assignment) -> Result<Submission> {
        if !folder.is_dir() {
            return Err(Error::input(
                format!("there is no folder {}", folder.display()),
                "name the folder that holds the answer files",
            ));
        }
        let holds_any = |place: &PathBuf| {
            assignment
                .tasks
                .iter()
                .any(|task| place.join(task.file()).symlink_metadata().is_ok())
        };
        let Some(place) = places(folder).into_iter().find(holds_any) else {
            let files: Vec<String> = assignment.tasks.iter().map(|task| task.file()).collect();
            return Err(Error::input(
                format!("{} holds no answer file", folder.display()),
                format!(
                    "name a folder that holds (itself or in `src`): {}",
                    files.join(", ")
                ),
            ));
        };
        let answers = assignment.tasks.iter().map(|task| Answer {
            task: task.name.clone(),
            text: read(&place.join(task.file())),
        });
        Ok(Submission {
            folder: folder.into(),
            answers: answers.collect(),
            place,
        })
    }

    /// The answer to this task.
    pub fn answer(&self, task: &str) -> Option<&Answer> {
        self.answers.iter().find(|answer| answer.task == task)
    }
}

fn places(folder: &Path) -> Vec<PathBuf> {
    // A link could lead into somebody else's answers.
    let is_own = |place: &PathBuf| !place.is_symlink();
    let mut places = vec![folder.into()];
    places.extend(Some(folder.join("src")).filter(is_own));
    let inside = fs::read_dir(folder).into_iter().flatten().flatten();
    // What archives and version control leave beside the answers' folder.
    let is_ordinary = |name: &str| !name.starts_with('.') && !name.starts_with("__");
    let folders: Vec<PathBuf> = inside
        .filter(|entry| entry.file_name().to_str().is_some_and(is_ordinary))
        .map(|entry| entry.path())
        .filter(|path| path.is_dir() && !path.is_symlink())
        .filter(|path| *path != folder.join("src"))
        .collect();
    if let [only] = folders.as_slice() {
        places.push(only.clone());
        places.extend(Some(only.join("src")).filter(is_own));
    }
    places
}

fn read(path: &Path) -> std::result::Result<String, Unusable> {
    // `symlink_metadata` looks at the link itself: a link could lead anywhere.
    let metadata = fs::symlink_metadata(path).map_err(|_| Unusable::Missing)?;
    let refused = |why: &str| Err(Unusable::Refused(why.into()));
    if !metadata.is_file() {
        return refused("it is not a regular file");
    }
    if metadata.len() > MOST_BYTES {
        return refused("it is longer than 256 KiB");
    }
    match fs::read(path).map(String::from_utf8) {
        Ok(Ok(text)) => Ok(text),
        Ok(Err(_)) => refused("it is not UTF-8 text"),
        Err(error) => refused(&error.to_string()),
    }
}
