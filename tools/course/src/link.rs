//! Links in paths that a person typed. A student may have made them, because people work in
//! folders that students have handed in.

use std::path::{Component, Path, PathBuf};

use crate::error::{Error, Result};

/// Refuses a path that is a link or, if it is relative to the current folder, leads through one.
///
/// # Errors
/// If there is a link.
pub fn refuse(path: &Path) -> Result<()> {
    match first(path) {
        Some(link) => Err(refusal(&link)),
        None if leads_elsewhere(path) == Some(true) => Err(refusal(path)),
        None => Ok(()),
    }
}

/// Refuses such a path of a submission, and also a path like `.` that stands for a folder which was
/// entered through a link, because that folder's name would be taken for the student's.
///
/// # Errors
/// If there is a link, or if nobody knows by which name the current folder was entered, and the path
/// depends on it.
pub fn refuse_input(path: &Path) -> Result<()> {
    refuse(path)?;
    match (is_renamed(path), leads_elsewhere(path)) {
        (Some(true), _) => Err(refusal(path)),
        (None, _) | (_, None) => Err(Error::input(
            format!(
                "nobody knows what {} means, because the variable PWD doesn't name the current folder",
                path.display()
            ),
            "write the full path",
        )),
        _ => Ok(()),
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

/// The first part of a path that is a link. Only the last part of an absolute path is looked at,
/// because nobody types a full path by accident.
fn first(path: &Path) -> Option<PathBuf> {
    // With a slash at its end, the path would be that of what a link leads to.
    let plain: PathBuf = path.components().collect();
    if plain.is_absolute() {
        return Some(plain).filter(|it| it.is_symlink());
    }
    let parts: Vec<&Path> = plain.ancestors().collect();
    let first = parts.into_iter().rev().find(|it| it.is_symlink());
    first.map(Path::to_owned)
}

/// Whether the folders above the current one, to which a path leads by `..`, are others than the
/// person thinks, because the current folder was entered through a link. `None` if nobody knows how it
/// was entered.
fn leads_elsewhere(path: &Path) -> Option<bool> {
    let ups = ups(path);
    if !cfg!(unix) || ups == 0 {
        return Some(false);
    }
    let above = |folder: &Path, ups: usize| {
        let above = folder.ancestors().nth(ups).unwrap_or(Path::new("/"));
        above.canonicalize().ok()
    };
    let (here, typed) = (std::env::current_dir().ok()?, typed_folder()?);
    Some((1..=ups).any(|ups| above(&typed, ups) != above(&here, ups)))
}

/// How many folders above the current one a relative path goes.
fn ups(path: &Path) -> usize {
    let (mut ups, mut inside) = (0, 0);
    for part in path.components() {
        match part {
            Component::ParentDir if inside == 0 => ups += 1,
            Component::ParentDir => inside -= 1,
            Component::Normal(_) => inside += 1,
            _ => {}
        }
    }
    ups
}

/// The current folder, by the names through which the person came here. Only the shell knows them.
fn typed_folder() -> Option<PathBuf> {
    let here = std::env::current_dir().ok()?;
    let typed = PathBuf::from(std::env::var_os("PWD")?);
    let is_here = typed.canonicalize().is_ok_and(|it| it == here);
    is_here.then_some(typed)
}

/// Whether a path without a name of its own, such as `.`, stands for a folder that was entered through
/// a link of another name. `None` if nobody knows.
fn is_renamed(path: &Path) -> Option<bool> {
    if !cfg!(unix) || path.file_name().is_some() {
        return Some(false);
    }
    let mut typed = typed_folder()?;
    for part in path.components() {
        match part {
            Component::ParentDir => drop(typed.pop()),
            part => typed.push(part),
        }
    }
    let real = path.canonicalize().unwrap_or_default();
    Some(real.file_name() != typed.file_name())
}

#[cfg(test)]
#[test]
fn only_parts_that_leave_the_current_folder_lead_above_it() {
    for (path, above) in [
        ("..", 1),
        ("../../a", 2),
        ("a/..", 0),
        ("a/../../b", 1),
        ("./a", 0),
    ] {
        assert_eq!(ups(Path::new(path)), above, "{path}");
    }
}
