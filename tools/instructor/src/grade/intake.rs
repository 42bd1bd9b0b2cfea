//! What was handed in: which of the paths are submissions, and what each is called.

pub mod roster;

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use super::provenance::sha256;
use pinhole_course::assignment::{Assignment, Task};
use pinhole_course::error::{Error, Fault, Result, ResultExt};
use pinhole_course::submission::{Answer, Submission, Unusable};

/// Something handed in.
#[derive(Clone, Debug, Deserialize, Eq, Ord, PartialEq, PartialOrd, Serialize)]
pub struct Entry {
    /// Its folder in the results: a plain name that no other entry has.
    pub id: String,
    /// The folder's or archive's name as it was handed in.
    pub name: String,
    /// Where it is; not kept, as it may name the instructor's home.
    #[serde(skip)]
    pub path: PathBuf,
}

/// Everything found.
#[derive(Clone, Debug, Default)]
pub struct Intake {
    /// By id.
    pub entries: Vec<Entry>,
    /// What lies among the submissions but is not one: listed, never dropped silently.
    pub ignored: Vec<String>,
}

/// What each path holds: itself a submission, or a folder of them.
pub fn find(paths: &[PathBuf], assignment: &Assignment) -> Result<Intake> {
    let mut found = Vec::new();
    let mut ignored = Vec::new();
    for path in paths {
        if path.is_file() || Submission::find_any(path, assignment)?.is_some() {
            found.push(path.clone());
            continue;
        }
        let entries = fs::read_dir(path).or_input(
            format_args!("cannot read {}", path.display()),
            "name a submission, or a folder of submissions",
        )?;
        let mut inside: Vec<PathBuf> = entries.flatten().map(|entry| entry.path()).collect();
        inside.sort();
        for path in inside {
            let name = name(&path);
            let is_link = path.is_symlink();
            if !is_link && !name.starts_with('.') && (path.is_dir() || is_archive(&path)) {
                found.push(path);
            } else if !name.starts_with('.') {
                ignored.push(name);
            }
        }
    }
    if found.is_empty() {
        return Err(Error::input(
            "there is no submission in what you named",
            "name folders that hold the answer files, or a folder of such folders",
        ));
    }
    let mut taken = BTreeSet::new();
    let mut entries: Vec<Entry> = found
        .into_iter()
        .map(|path| {
            let name = name(&path);
            let mut id = plain(&name);
            let base = id.clone();
            let mut count = 2;
            // Case alone does not tell folders apart everywhere.
            while !taken.insert(id.to_lowercase()) {
                id = format!("{base}.{count}");
                count += 1;
            }
            Entry { id, name, path }
        })
        .collect();
    entries.sort();
    ignored.sort();
    Ok(Intake { entries, ignored })
}

/// The name people see.
fn name(path: &Path) -> String {
    let absolute = path.canonicalize().unwrap_or(path.into());
    let name = absolute.file_name().unwrap_or_default();
    name.to_string_lossy().into_owned()
}

fn is_archive(path: &Path) -> bool {
    let end = path.extension().and_then(|end| end.to_str());
    end.is_some_and(|end| end.eq_ignore_ascii_case("zip"))
}

/// Longer names are cut.
const MOST_CHARACTERS: usize = 80;

/// A name that is safe for a folder on every system. A hash keeps names apart that had to
/// change.
fn plain(name: &str) -> String {
    let stem = match name.get(name.len().saturating_sub(4)..) {
        Some(end) if end.eq_ignore_ascii_case(".zip") => &name[..name.len() - 4],
        _ => name,
    };
    let is_plain = |c: char| c.is_ascii_alphanumeric() || "._-".contains(c);
    let safe: String = stem
        .chars()
        .map(|c| if is_plain(c) { c } else { '_' })
        .take(MOST_CHARACTERS)
        .collect();
    let safe = safe.trim_matches(|c| c == '.' || c == ' ').to_owned();
    match safe == stem && !safe.is_empty() {
        true => safe,
        false => format!("{safe}-{}", &sha256(name.as_bytes())[..8]),
    }
}

/// A submission's answers. Whatever is wrong with what was handed in becomes files that
/// are missing or refused; only a fault of the machine's is an error.
pub fn open(entry: &Entry, assignment: &Assignment) -> Result<Submission> {
    let unusable = match Submission::find_any(&entry.path, assignment) {
        Ok(Some(submission)) => return Ok(submission),
        Ok(None) => Unusable::Missing,
        Err(error) if error.fault == Fault::Environment || !entry.path.exists() => {
            return Err(error);
        }
        Err(error) => {
            // The path is the instructor's own business.
            let path = entry.path.display().to_string();
            Unusable::Refused(error.problem.replace(&path, &entry.name))
        }
    };
    Ok(without_answers(entry, assignment, &unusable))
}

/// A submission of which no file can be used.
pub fn without_answers(entry: &Entry, assignment: &Assignment, why: &Unusable) -> Submission {
    let answer = |task: &Task| Answer {
        task: task.name.clone(),
        text: Err(why.clone()),
    };
    Submission {
        folder: entry.path.clone(),
        place: entry.path.clone(),
        answers: assignment.tasks.iter().map(answer).collect(),
    }
}

/// The share of shard `k` of `n`, 1 to n: every n-th, so that a slow class is even.
pub fn shard<T>(all: Vec<T>, shard: Option<(usize, usize)>) -> Vec<T> {
    let Some((k, n)) = shard else { return all };
    let mine = all
        .into_iter()
        .enumerate()
        .filter(|(at, _)| at % n == k - 1);
    mine.map(|(_, entry)| entry).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_hostile_name_becomes_a_plain_folder_of_its_own() {
        for name in ["../../etc", "a/b", "..", "", "x\u{1b}[31m", "<script>"] {
            let id = plain(name);
            assert!(
                !id.contains(['/', '\\', '<', '\u{1b}']) && !id.starts_with('.'),
                "{id}"
            );
        }
        assert_ne!(plain("a b"), plain("a?b"));
        assert_eq!(plain("alice.zip"), "alice");
    }

    #[test]
    fn shards_share_out_everybody_once() {
        let all: Vec<u32> = (0..10).collect();
        let mut shared: Vec<u32> = (1..=3)
            .flat_map(|k| shard(all.clone(), Some((k, 3))))
            .collect();
        shared.sort();
        assert_eq!(shared, all);
    }
}
