//! Recognises archives, and files that are left out, by their names. Shortens lists of names.

use crate::grade::intake::names::{Platform, PlatformName, platforms};

/// The extensions of archives; only those in the first list are opened.
const OPENED: [&str; 4] = [".zip", ".tar", ".tgz", ".tar.gz"];
const CLOSED: [&str; 7] = [".rar", ".7z", ".xz", ".txz", ".bz2", ".zst", ".gz"];

fn ends(name: &str, ends: &[&str]) -> bool {
    let name = name.as_bytes();
    let has_end = |end: &&str| {
        let start = name.len().checked_sub(end.len());
        start.is_some_and(|start| name[start..].eq_ignore_ascii_case(end.as_bytes()))
    };
    ends.iter().any(has_end)
}

/// Whether a name is that of an archive that is unpacked.
pub fn is_opened(name: &str) -> bool {
    ends(name, &OPENED)
}

/// Whether a name is an archive's.
pub fn is_archive(name: &str) -> bool {
    is_opened(name) || ends(name, &CLOSED)
}

/// A name without an archive's extension.
pub fn stem(name: &str) -> &str {
    let mut found = OPENED.iter().filter(|end| ends(name, &[*end]));
    let end = found.next_back().map_or(0, |end| end.len());
    name.get(..name.len() - end).unwrap_or(name)
}

/// Whether a path, after its first `from` parts, goes through a folder made by a program: by
/// version control, a build, or the operating system. Such a folder contains no answers.
pub fn is_skipped(path: &[String], from: usize) -> bool {
    let is_inside = path.len() > 1;
    let mut below = path[from.min(path.len())..].iter();
    below.any(|name| is_litter(name) || is_inside && (is_hidden(name) || name == "target"))
}

/// Whether a folder is hidden on Unix. But people may have display names that begin with a dot.
pub fn is_hidden(name: &str) -> bool {
    name.starts_with('.') && platforms(name).is_empty()
}

/// Whether this is a file that operating systems leave in every folder. But somebody on Moodle may be
/// called `.`.
fn is_litter(name: &str) -> bool {
    let litter = ["__MACOSX", ".DS_Store", "Thumbs.db", "desktop.ini"];
    let is_dot = |it: &PlatformName| it.platform == Platform::Moodle && it.person == ".";
    litter.contains(&name) || name.starts_with("._") && !platforms(name).iter().any(is_dot)
}

/// How many names of a list are shown.
const MOST_SHOWN: usize = 5;

/// The first of these names, each in backticks, which no name contains. Otherwise a name could
/// continue the sentence that it stands in.
pub fn quoted(names: &[String]) -> Vec<String> {
    first(
        &names
            .iter()
            .map(|name| format!("`{name}`"))
            .collect::<Vec<_>>(),
    )
}

/// The first of these names. An archive may contain a hundred thousand files.
pub fn first(names: &[String]) -> Vec<String> {
    let mut shown = names[..names.len().min(MOST_SHOWN)].to_vec();
    let more = names.len() - shown.len();
    shown.extend((more > 0).then(|| format!("{more} more like these")));
    shown
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_of_operating_systems_are_skipped_but_nobody_called_by_a_dot() {
        for (name, is_left_out) in [
            ("._sphere.rs", true),
            ("._lovelaceada_11_501_hw.zip", true),
            ("._Ada Lovelace_2001_assignsubmission_file_hw.zip", true),
            ("._2001_assignsubmission_file", false),
            (". Plato_2001_assignsubmission_file", false),
        ] {
            assert_eq!(is_skipped(&[name.into()], 0), is_left_out, "{name}");
        }
    }
}
