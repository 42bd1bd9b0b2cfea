//! Every package that we depend on comes from crates.io and has a licence that `deny.toml`
//! accepts.
//!
//! `cargo deny check licenses sources` checks this too, but cargo-deny takes minutes to install.

use std::fs;
use std::process::Command;

use pinhole_testing::root;
use serde_json::Value;
use spdx::{Expression, ParseMode};

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
    let accepted = accepted();
    let wrong: Vec<String> = packages
        .iter()
        .filter_map(|package| problem(package, &accepted))
        .collect();
    assert_eq!(wrong, Vec::<String>::new());
}

#[test]
fn another_source_or_licence_is_a_problem() {
    let accepted = accepted();
    let is_wrong = |source: &str, license: &str| {
        let package = serde_json::json!({ "name": "a", "source": source, "license": license });
        problem(&package, &accepted).is_some()
    };
    assert!(!is_wrong(CRATES_IO, "MIT OR GPL-3.0-only"));
    assert!(!is_wrong(CRATES_IO, "MIT/Apache-2.0"));
    assert!(is_wrong(CRATES_IO, "MIT AND GPL-3.0-only"));
    assert!(is_wrong(CRATES_IO, ""));
    assert!(is_wrong("git+https://example.org/a", "MIT"));
}

/// The licences that `deny.toml` accepts.
fn accepted() -> Vec<String> {
    let text = fs::read_to_string(root().join("deny.toml")).expect("it is there");
    let table: toml::Table = text.parse().expect("it is TOML");
    let licences = table["licenses"]["allow"].as_array().expect("a list");
    let licences = licences
        .iter()
        .map(|licence| licence.as_str().expect("a name").into());
    licences.collect()
}

/// What is wrong with a package of `cargo metadata`, if anything.
fn problem(package: &Value, accepted: &[String]) -> Option<String> {
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
                .is_some_and(|id| accepted.iter().any(|name| name == id.name))
        })
    });
    (!is_accepted).then(|| format!("{name} has licence {licence:?}"))
}
