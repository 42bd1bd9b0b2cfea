//! Known mistakes are seen where they are made, and right answers by other routes
//! lose nothing.

use std::fs;
use std::path::{Path, PathBuf};

use crate::course::{pinhole, root, submission, trusted};
use serde_json::Value;

/// The folders in `assignments/ray_casting/KIND`, each an overlay on the reference.
fn overlays(kind: &str) -> Vec<PathBuf> {
    let folder = root().join("assignments/ray_casting").join(kind);
    let entries = fs::read_dir(folder).expect("the folder is there").flatten();
    let mut folders: Vec<PathBuf> = entries.map(|entry| entry.path()).collect();
    folders.sort();
    folders
}

/// Lays an overlay over the reference and has both judges look at everything.
fn check(overlay: &Path) -> Value {
    let slug = overlay
        .file_name()
        .and_then(|name| name.to_str())
        .expect("slugs are plain");
    let entries = fs::read_dir(overlay)
        .expect("the overlay can be read")
        .flatten();
    let answers = entries.map(|entry| entry.path());
    let answers = answers.filter(|path| path.extension().is_some_and(|end| end == "rs"));
    let answers: Vec<(String, String)> = answers
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

/// The tasks that lost a point.
fn failing(examination: &Value) -> Vec<String> {
    let tasks = examination["tasks"].as_array().expect("tasks are a list");
    let failing = tasks
        .iter()
        .filter(|task| task["points"] != task["possible"]);
    failing
        .map(|task| task["name"].as_str().expect("a name").to_owned())
        .collect()
}

fn declared(overlay: &Path) -> Vec<String> {
    let text = fs::read_to_string(overlay.join("mistake.toml")).expect("every mistake declares");
    let table: toml::Table = text.parse().expect("it is TOML");
    assert!(
        table["belief"]
            .as_str()
            .is_some_and(|belief| !belief.is_empty()),
        "{overlay:?}"
    );
    let fails = table["fails"].as_array().expect("`fails` is a list").iter();
    fails
        .map(|task| task.as_str().expect("a task").to_owned())
        .collect()
}

#[test]
fn every_known_mistake_fails_in_its_own_task_and_in_no_other() {
    let mut problems = Vec::new();
    let mistakes = overlays("mistakes");
    for mistake in &mistakes {
        let mut expected = declared(mistake);
        expected.sort();
        let examination = check(mistake);
        let mut got = failing(&examination);
        got.sort();
        let states = examination["tasks"].as_array().expect("a list").iter();
        let compiles = states
            .into_iter()
            .all(|task| task["file"]["state"] == "compiled");
        if got != expected || expected.is_empty() || !compiles {
            problems.push(format!(
                "{}: declared {expected:?}, failed {got:?}",
                mistake.display()
            ));
        }
    }
    assert!(problems.is_empty(), "{}", problems.join("\n"));
    assert!(
        mistakes.len() >= 25,
        "only {} mistakes were found",
        mistakes.len()
    );
}

#[test]
fn right_answers_by_other_routes_get_full_points() {
    let variants = overlays("variants");
    for variant in &variants {
        let examination = check(variant);
        assert_eq!(
            examination["passes"],
            true,
            "{}: {examination:#}",
            variant.display()
        );
    }
    assert!(
        variants.len() >= 6,
        "only {} variants were found",
        variants.len()
    );
}

#[test]
fn the_readme_shows_what_check_prints() {
    let readme = fs::read_to_string(root().join("README.md")).expect("it is there");
    let shown = readme
        .split("-- check --task sphere\n")
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
