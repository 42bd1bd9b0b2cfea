//! Known mistakes and variants, judged by both judges. `validate` checks every verdict.

use std::fs;
use std::path::{Path, PathBuf};

use pinhole_testing::{pinhole, root, submission, trusted};
use serde_json::Value;

/// The folders in `assignments/ray_casting/KIND` that hold answers, each an overlay on the
/// reference.
fn overlays(kind: &str) -> Vec<PathBuf> {
    let folder = root().join("assignments/ray_casting").join(kind);
    let entries = fs::read_dir(folder).expect("the folder is there").flatten();
    let mut folders: Vec<PathBuf> = entries
        .map(|entry| entry.path())
        .filter(|folder| !answers(folder).is_empty())
        .collect();
    folders.sort();
    folders
}

/// The answer files in a folder.
fn answers(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).expect("the overlay can be read");
    let files = entries.flatten().map(|entry| entry.path());
    files
        .filter(|path| path.extension().is_some_and(|end| end == "rs"))
        .collect()
}

/// Lays an overlay over the reference and lets both judges judge everything.
fn check(overlay: &Path) -> Value {
    let slug = overlay
        .file_name()
        .and_then(|name| name.to_str())
        .expect("slugs are plain");
    let answers: Vec<(String, String)> = answers(overlay)
        .into_iter()
        .map(|path| {
            let name = path
                .file_name()
                .expect("it has a name")
                .to_string_lossy()
                .into_owned();
            (name, fs::read_to_string(path).expect("answers are text"))
        })
        .collect();
    let overlay: Vec<(&str, &str)> = answers
        .iter()
        .map(|(name, text)| (name.as_str(), text.as_str()))
        .collect();
    let folder = submission(&trusted(), slug, &overlay);
    let folder_name = folder.to_str().expect("a plain name");
    let examination = pinhole(&["check", folder_name, "--json", "--oiiotool"]).json();
    fs::remove_dir_all(folder).expect("it was made");
    examination
}

#[test]
fn both_judges_agree_on_a_sample_of_mistakes_and_variants() {
    // `validate --oiiotool` asks about all of them, which takes many minutes.
    for (kind, step, passes) in [("mistakes", 24, false), ("variants", 24, true)] {
        for overlay in overlays(kind).iter().step_by(step) {
            let examination = check(overlay);
            assert_eq!(
                examination["passes"],
                passes,
                "{}: {examination:#}",
                overlay.display()
            );
        }
    }
}

#[test]
fn the_readme_shows_what_check_prints() {
    let readme = fs::read_to_string(root().join("README.md")).expect("it is there");
    let shown = readme
        .split("cargo pinhole check --task sphere\n")
        .nth(1)
        .expect("the listing is there");
    let shown = shown.split("```").next().expect("the listing ends");
    let mistake = root().join("assignments/ray_casting/mistakes/sphere_near_root_only/sphere.rs");
    let text = fs::read_to_string(mistake).expect("it is there");
    let folder = submission(&trusted(), "readme", &[("sphere.rs", &text)]);
    let ran = pinhole(&["check", folder.to_str().expect("plain"), "--task", "sphere"]);
    for line in shown
        .lines()
        .filter(|line| !line.trim().is_empty() && line.trim() != "…")
    {
        assert!(
            ran.out.contains(line),
            "the README shows {line:?}, but check prints:\n{}",
            ran.out
        );
    }
}
