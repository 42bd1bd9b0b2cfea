//! `pinhole --version`: the program, the commit of the checkout, and the goldens' version.

use std::ffi::OsString;
use std::path::Path;
use std::{env, fs};

use pinhole_course::checkout::Checkout;
use pinhole_course::manifest::hash_of;
use pinhole_course::rust_tool::tool;

/// How many digits of a commit or of a hash are shown.
const DIGITS: usize = 12;

/// The output of `--version`, if the command line asks for it.
pub fn asked() -> Option<String> {
    let mut words: Vec<OsString> = env::args_os().skip(1).collect();
    let word = words.pop()?;
    let is_asked = words.is_empty() && (word == "--version" || word == "-V");
    is_asked.then(|| text(Checkout::find().ok().as_ref()))
}

fn text(checkout: Option<&Checkout>) -> String {
    let mut lines = vec![format!("pinhole {}", env!("CARGO_PKG_VERSION"))];
    if let Some(checkout) = checkout {
        let commit = commit(checkout.root()).unwrap_or("unknown".into());
        lines.push(format!("commit {commit}"));
        lines.extend(goldens(checkout.root()));
    }
    lines.join("\n")
}

/// The current commit, with `-dirty` if files differ from it.
fn commit(root: &Path) -> Option<String> {
    let abbreviation = format!("--abbrev={DIGITS}");
    let described = tool("git", root)
        .args([
            "describe",
            "--always",
            "--dirty",
            "--exclude=*",
            &abbreviation,
        ])
        .output()
        .ok()
        .filter(|output| output.status.success())?;
    Some(String::from_utf8(described.stdout).ok()?.trim().to_owned())
}

/// A line for each assignment with goldens. Their version is the hash of their manifest,
/// which holds the hash of every film.
fn goldens(root: &Path) -> Vec<String> {
    let entries = fs::read_dir(root.join("golden")).into_iter().flatten();
    let line = |folder: fs::DirEntry| {
        let path = folder.path().join("manifest.toml");
        let bytes = fs::read(&path).ok()?;
        let hash = &hash_of(&path, bytes)[..DIGITS];
        Some(format!("goldens {} {hash}", folder.file_name().display()))
    };
    let mut lines: Vec<String> = entries.flatten().filter_map(line).collect();
    lines.sort();
    lines
}
