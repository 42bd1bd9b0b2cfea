//! Every package that we depend on comes from crates.io and has a licence that we accept.
//!
//! This is what `cargo deny check licenses sources` would check, without a tool that takes
//! minutes to install.

use std::process::Command;

use pinhole_testing::root;
use serde_json::Value;
use spdx::{Expression, ParseMode};

/// Licences under which the programs can be used, changed and handed on by everybody.
const ACCEPTED: [&str; 11] = [
    "Apache-2.0",
    "BSD-2-Clause",
    "BSD-3-Clause",
    "CC-BY-4.0",
    "CC0-1.0",
    "ISC",
    "MIT",
    "MIT-0",
    "MPL-2.0",
    "Unicode-3.0",
    "Zlib",
];

/// Where cargo gets crates.io's packages from.
const CRATES_IO: &str = "registry+https://github.com/rust-lang/crates.io-index";

#[test]
fn every_dependency_is_from_crates_io_and_has_an_accepted_licence() {
    let cargo = std::env::var_os("CARGO").unwrap_or("cargo".into());
    let output = Command::new(cargo)
        .args(["metadata", "--format-version", "1", "--locked"])
        .current_dir(root())
        .output()
        .expect("cargo starts");
    let metadata: Value = serde_json::from_slice(&output.stdout).expect("cargo prints JSON");
    let packages = metadata["packages"].as_array().expect("there are packages");
    assert!(packages.len() > 100, "only {} packages", packages.len());
    let wrong: Vec<String> = packages.iter().filter_map(problem).collect();
    assert_eq!(wrong, Vec::<String>::new());
}

#[test]
fn another_source_or_licence_is_a_problem() {
    let package = |source: &str, license: &str| serde_json::json!({ "name": "a", "source": source, "license": license });
    assert_eq!(problem(&package(CRATES_IO, "MIT OR GPL-3.0-only")), None);
    assert_eq!(problem(&package(CRATES_IO, "MIT/Apache-2.0")), None);
    assert!(problem(&package(CRATES_IO, "MIT AND GPL-3.0-only")).is_some());
    assert!(problem(&package(CRATES_IO, "")).is_some());
    assert!(problem(&package("git+https://example.org/a", "MIT")).is_some());
}

/// What is wrong with a package of `cargo metadata`, if anything.
fn problem(package: &Value) -> Option<String> {
    let name = &package["name"];
    // Our own packages have no source.
    if let Some(source) = package["source"].as_str().filter(|it| *it != CRATES_IO) {
        return Some(format!("{name} comes from {source}"));
    }
    let licence = package["license"].as_str().unwrap_or_default();
    let expression = Expression::parse_mode(licence, ParseMode::LAX);
    let is_accepted = expression.is_ok_and(|expression| {
        expression.evaluate(|it| {
            it.license
                .id()
                .is_some_and(|id| ACCEPTED.contains(&id.name))
        })
    });
    (!is_accepted).then(|| format!("{name} has licence {licence:?}"))
}
