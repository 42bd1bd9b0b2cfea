//! The files that are copied unchanged.
//!
//! Files are listed by folder and kind. We don't ask git for them, because a course may have come
//! as an archive. Other files beside the sources, such as those that editors leave, must not be
//! handed out.

use std::fs;
use std::path::Path;

use super::Files;
use pinhole_course::checkout::Checkout;
use pinhole_course::error::{Error, Result, ResultExt};

/// The files at the top of the checkout, beside its manifest.
const TOP: [&str; 6] = [
    ".cargo/config.toml",
    "Cargo.lock",
    "LICENSE",
    "README.md",
    ".gitignore",
    ".gitattributes",
];

/// The files at the top of every workspace that is handed out.
pub fn add_top(files: &mut Files, checkout: &Checkout) -> Result<()> {
    TOP.iter().try_for_each(|name| add(files, checkout, name))?;
    add_folder(files, checkout, "book/figures", &["png"])
}

/// Adds one file of the checkout under its own path.
fn add(files: &mut Files, checkout: &Checkout, path: &str) -> Result<()> {
    files.insert(path.into(), read(&checkout.root().join(path))?);
    Ok(())
}

/// Adds the files of these kinds in a folder and its subfolders; without kinds, all files. Leaves
/// out links and hidden files, which may lead to files that must not be handed out.
pub fn add_folder(
    files: &mut Files,
    checkout: &Checkout,
    folder: &str,
    kinds: &[&str],
) -> Result<()> {
    add_folder_as(files, &checkout.root().join(folder), folder, kinds)
}

/// Like [`add_folder`], but for any folder, and under another path.
pub fn add_folder_as(files: &mut Files, path: &Path, folder: &str, kinds: &[&str]) -> Result<()> {
    let entries = fs::read_dir(path).or_fail(&unreadable(path))?;
    for entry in entries.flatten() {
        let Ok(name) = entry.file_name().into_string() else {
            continue;
        };
        let inside = format!("{folder}/{name}");
        let kind = entry.file_type().or_fail(&unreadable(path))?;
        let wanted = |kind: &&str| name.ends_with(&format!(".{kind}"));
        if name.starts_with('.') {
            continue;
        } else if kind.is_dir() {
            add_folder_as(files, &entry.path(), &inside, kinds)?;
        } else if kind.is_file() && (kinds.is_empty() || kinds.iter().any(wanted)) {
            files.insert(inside, read(&entry.path())?);
        }
    }
    Ok(())
}

/// The content of a file.
pub fn read(path: &Path) -> Result<Vec<u8>> {
    fs::read(path).or_fail(&unreadable(path))
}

/// The content of a text file, with `\n` line ends.
pub fn read_text(path: &Path) -> Result<String> {
    match String::from_utf8(read(path)?) {
        Ok(text) => Ok(text.replace("\r\n", "\n")),
        Err(_) => Err(Error::input(
            format!("{} is not UTF-8 text", path.display()),
            "restore the file",
        )),
    }
}

fn unreadable(path: &Path) -> Error {
    Error::input(
        format!("cannot read {}", path.display()),
        "restore it; the instructor's repository has it",
    )
}
