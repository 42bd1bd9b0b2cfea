//! Links in paths that a person typed. A student may have made them, because people work in
//! folders that students have handed in.

use std::path::{Component, Path, PathBuf};

use crate::error::{Error, Result};

/// Refuses a path that is a link or, if it is relative to the current folder, leads through one.
///
/// # Errors
/// If there is a link.
pub fn refuse(path: &Path) -> Result<()> {
    first(path).map_or(Ok(()), |link| Err(refusal(&link)))
}

/// Refuses such a path of a submission, and also a path like `.` if it stands for a folder that was
/// entered through a link, whose name would be taken for the student's.
///
/// # Errors
/// If there is a link.
pub fn refuse_input(path: &Path) -> Result<()> {
    match is_renamed(path) {
        true => Err(refusal(path)),
        false => refuse(path),
    }
}

fn refusal(link: &Path) -> Error {
    Error::input(
        format!(
            "{} is a link, or leads through one, and a student may have made it",
            link.display()
        ),
        "name a place that is not a link and contains none, by its full path",
    )
}

/// The first part of a path that is a link, or that leads through a link by `..`. Only the last
/// part of an absolute path is looked at, because nobody types a full path by accident.
fn first(path: &Path) -> Option<PathBuf> {
    // With a slash at its end, the path would be that of what a link leads to.
    let plain: PathBuf = path.components().collect();
    if plain.is_absolute() {
        return Some(plain).filter(|it| it.is_symlink());
    }
    let is_up = |part: &Component| *part == Component::ParentDir;
    if cfg!(unix) && leads_elsewhere(plain.components().filter(is_up).count()) {
        return Some(plain);
    }
    let parts: Vec<&Path> = plain.ancestors().collect();
    let first = parts.into_iter().rev().find(|it| it.is_symlink());
    first.map(Path::to_owned)
}

/// Whether one of so many folders above the current one is another than the person thinks, because
/// the current folder was entered through a link. Also true if nobody knows how it was entered.
fn leads_elsewhere(ups: usize) -> bool {
    let above = |folder: &Path, ups: usize| {
        let above = folder.ancestors().nth(ups).unwrap_or(Path::new("/"));
        above.canonicalize().ok()
    };
    let here = std::env::current_dir().unwrap_or_default();
    let differ = |typed: &Path| (1..=ups).any(|ups| above(typed, ups) != above(&here, ups));
    ups > 0 && typed_folder().is_none_or(|typed| differ(&typed))
}

/// The current folder, by the names through which the person came here. Only the shell knows them.
fn typed_folder() -> Option<PathBuf> {
    let here = std::env::current_dir().ok()?;
    let typed = PathBuf::from(std::env::var_os("PWD")?);
    typed
        .canonicalize()
        .is_ok_and(|it| it == here)
        .then_some(typed)
}

/// Whether a path without a name of its own, such as `.`, may stand for a folder that was entered
/// through a link of another name.
fn is_renamed(path: &Path) -> bool {
    if path.file_name().is_some() {
        return false;
    }
    let Some(mut typed) = typed_folder() else {
        return true;
    };
    for part in path.components() {
        match part {
            Component::ParentDir => drop(typed.pop()),
            part => typed.push(part),
        }
    }
    let real = path.canonicalize().unwrap_or_default();
    real.file_name() != typed.file_name()
}
