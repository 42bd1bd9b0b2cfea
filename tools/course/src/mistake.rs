//! Known mistakes: wrong answers with the belief behind them.

use std::fs;
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use crate::assignment::{Assignment, Task};
use crate::error::{Error, Result, ResultExt};

/// A belief that leads to wrong answers, and hints for a student who holds it.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Mistake {
    /// The belief, in a student's own words.
    pub belief: String,
    /// The tasks whose answers the mistake makes wrong. All others keep their points.
    pub fails: Vec<String>,
    /// How many of the public solutions that were read contain the mistake, if that was counted.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub submissions: Option<u32>,
    /// The chapter of the book that helps.
    pub chapter: String,
    /// The single mistakes, if this mistake combines several.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub beliefs: Vec<String>,
    /// Help at three levels.
    pub hint: Hint,
}

/// Help at three levels, none of which gives the answer away: `look`, `think`, and
/// `example` together with `read`.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Hint {
    /// Where to look.
    pub look: String,
    /// What to think about.
    pub think: String,
    /// A small case in numbers, to be worked out by hand. Only combined mistakes have none,
    /// because no diagnosis names them.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub example: Option<String>,
    /// The section of the chapter to read.
    pub read: String,
}

/// A folder of `mistakes`.
#[derive(Clone, Debug)]
pub struct MistakeFolder {
    /// The folder's name.
    pub slug: String,
    /// Where it is: `mistake.toml`, the wrong answer files and, in `rewrite`, other files that
    /// apply the same belief to another algorithm. A combined mistake whose beliefs are about
    /// different tasks has no files of its own; see [`MistakeFolder::overlays`].
    pub folder: PathBuf,
    /// What is believed.
    pub mistake: Mistake,
}

impl Mistake {
    /// Whether it is a single belief.
    pub fn is_single(&self) -> bool {
        self.beliefs.is_empty()
    }
}

impl MistakeFolder {
    /// The folders to lay over right answers, one after the other: its own, or, if it combines
    /// beliefs and has no answer file, those of its beliefs.
    ///
    /// # Errors
    /// If two beliefs answer the same task, because only the later answer would count.
    pub fn overlays(&self, assignment: &Assignment) -> Result<Vec<PathBuf>> {
        let answers = |folder: &PathBuf, task: &Task| folder.join(task.file()).is_file();
        let mut tasks = assignment.tasks.iter();
        if self.mistake.is_single() || tasks.any(|task| answers(&self.folder, task)) {
            return Ok(vec![self.folder.clone()]);
        }
        let beliefs = self.mistake.beliefs.iter();
        let folders: Vec<PathBuf> = beliefs
            .map(|belief| assignment.folder.join("mistakes").join(belief))
            .collect();
        let shared = assignment.tasks.iter().find(|task| {
            let answering = folders.iter().filter(|folder| answers(folder, task));
            answering.count() > 1
        });
        match shared {
            None => Ok(folders),
            Some(task) => Err(Error::input(
                format!("{}: two of its beliefs are about {}", self.slug, task.name),
                format!("put a {} with both mistakes into its folder", task.file()),
            )),
        }
    }
}

/// The mistakes of an assignment by name. Empty if the assignment came without them.
pub fn read_all(assignment: &Assignment) -> Result<Vec<MistakeFolder>> {
    folders(&assignment.folder.join("mistakes"))
        .into_iter()
        .map(|(slug, folder)| {
            let path = folder.join("mistake.toml");
            let wrong = Error::input(
                path.display().to_string(),
                "correct the file; another mistake's can serve as an example",
            );
            let text = fs::read_to_string(&path).or_fail(&wrong)?;
            let mistake: Mistake = toml::from_str(&text).or_fail(&wrong)?;
            let unknown = mistake
                .fails
                .iter()
                .find(|task| assignment.task(task).is_none());
            match unknown {
                Some(task) => Err(wrong.because(format!("there is no task `{task}`"))),
                None => Ok(MistakeFolder {
                    slug,
                    folder,
                    mistake,
                }),
            }
        })
        .collect()
}

/// The folders in `folder`, by name.
pub fn folders(folder: &Path) -> Vec<(String, PathBuf)> {
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    let mut folders: Vec<(String, PathBuf)> = entries
        .filter(|entry| entry.path().is_dir())
        .filter_map(|entry| Some((entry.file_name().into_string().ok()?, entry.path())))
        .collect();
    folders.sort();
    folders
}
