//! Imports between packages point one way.

use std::collections::BTreeMap;
use std::fs;
use std::process::Command;

use pinhole_testing::root;

/// Each package's folder, and which of our packages it may import.
const PACKAGES: [(&str, &[&str]); 8] = [
    (".", &[]),
    ("tools/reading", &[]),
    ("tools/course", &["pinhole"]),
    ("tools/report", &["pinhole", "pinhole-course"]),
    (
        "tools/cli",
        &["pinhole", "pinhole-course", "pinhole-report"],
    ),
    (
        "tools/instructor",
        &[
            "pinhole",
            "pinhole-course",
            "pinhole-reading",
            "pinhole-report",
        ],
    ),
    (
        "tools/study",
        &["pinhole", "pinhole-course", "pinhole-report"],
    ),
    (
        "tools/book",
        &["pinhole", "pinhole-course", "pinhole-reading"],
    ),
];

#[test]
fn packages_import_only_those_below_them() {
    for (folder, allowed) in PACKAGES {
        let path = root().join(folder).join("Cargo.toml");
        let text = fs::read_to_string(path).expect("it has a manifest");
        let manifest: toml::Table = text.parse().expect("it is TOML");
        let needed = manifest.get("dependencies").and_then(|it| it.as_table());
        for name in needed.into_iter().flat_map(|table| table.keys()) {
            let is_ours = name == "pinhole" || name.starts_with("pinhole-");
            assert!(
                !is_ours || allowed.contains(&name.as_str()),
                "{folder} imports {name}"
            );
        }
    }
}

/// The packages that one of ours is built from, each with its features.
fn built_from(package: &str) -> BTreeMap<String, String> {
    let output = Command::new(env!("CARGO"))
        .args([
            "tree",
            "--package",
            package,
            "--edges",
            "normal,no-proc-macro",
        ])
        .args(["--prefix", "none", "--no-dedupe", "--format", "{p}|{f}"])
        .current_dir(root())
        .output()
        .expect("cargo starts");
    let tree = String::from_utf8(output.stdout).expect("it is text");
    let lines = tree.lines().filter_map(|line| line.split_once('|'));
    let owned = |(package, features): (&str, &str)| (package.to_owned(), features.to_owned());
    lines.map(owned).collect()
}

#[test]
fn the_harness_is_built_once_for_students_and_instructors() {
    let (student, instructor) = (built_from("pinhole-cli"), built_from("pinhole-instructor"));
    let harness = built_from("pinhole");
    assert!(harness.len() > 10, "{harness:?}");
    for package in harness.keys() {
        assert_eq!(
            student[package], instructor[package],
            "{package} is built twice, and so is everything that needs it: give it the same \
             features in both programs"
        );
    }
}
