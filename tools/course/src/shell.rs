//! Command lines that people can copy into a terminal.

use std::path::{Component, Path, PathBuf};

/// How this command is run from its checkout.
pub const PINHOLE: &str = "cargo pinhole";

/// Quotes one word of a command line if the shell would split or expand it. The result is still
/// untrusted text.
///
/// ```
/// use pinhole_course::shell::in_shell;
///
/// assert_eq!(in_shell("my answers"), "'my answers'");
/// assert_eq!(in_shell("answers"), "answers");
/// ```
pub fn in_shell(word: &str) -> String {
    let plain = |c: char| c.is_alphanumeric() || "/._-+:\\".contains(c);
    match word.chars().all(plain) {
        true => word.into(),
        false => format!("'{}'", word.replace('\'', "'\\''")),
    }
}

/// The shortest path that opens from the current folder.
pub fn from_here(path: &Path) -> PathBuf {
    let here = std::env::current_dir().unwrap_or_default();
    let path = path.strip_prefix(here).unwrap_or(path);
    let parts = path.components();
    let inside: PathBuf = parts.filter(|part| *part != Component::CurDir).collect();
    match inside.as_os_str().is_empty() {
        true => PathBuf::from("."),
        false => inside,
    }
}
