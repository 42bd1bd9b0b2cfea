//! Imports between packages point one way.

use std::fs;

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
