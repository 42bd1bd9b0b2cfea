//! Imports point one way: between packages, and between the modules of each.
//!
//! A package may import those before it in [`PACKAGES`], a module those before it in its
//! package's list. A new module goes into the list where its imports allow.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use pinhole_testing::root;

/// Every package's folder, what it may import of ours, and its modules from the bottom up.
const PACKAGES: [(&str, &[&str], &[&str]); 7] = [
    (
        ".",
        &[],
        &[
            "error",
            "fact",
            "ray",
            "words",
            "camera",
            "film",
            "mesh",
            "source",
            "shape",
            "scene",
            "kind",
            "job",
            "serve",
            "ask",
            "judge",
            "report",
            "oiiotool",
            "false_colour",
        ],
    ),
    (
        "tools/course",
        &["pinhole"],
        &[
            "error",
            "escape",
            "shell",
            "checkout",
            "progress",
            "mitsuba",
            "assignment",
            "mistake",
            "diagnosis",
            "manifest",
            "handout_record",
            "stubs",
            "submission",
            "overlay",
            "sandbox",
            "run_options",
            "goldens",
            "describe",
            "second_judge",
            "compile",
            "outcome",
            "examine",
            "explanation",
        ],
    ),
    (
        "tools/report",
        &["pinhole", "pinhole-course"],
        &[
            "desktop", "passage", "program", "pictures", "cast", "terminal", "json", "html",
        ],
    ),
    (
        "tools/cli",
        &["pinhole", "pinhole-course", "pinhole-report"],
        &["cli", "programs", "watch", "command"],
    ),
    (
        "tools/instructor",
        &["pinhole", "pinhole-course", "pinhole-report"],
        &["golden", "validate", "grade", "handout", "cli", "command"],
    ),
    (
        "tools/study",
        &["pinhole", "pinhole-course", "pinhole-report"],
        &[
            "number",
            "vector",
            "double_double",
            "dyadic",
            "leading",
            "root",
            "shape",
            "kernel",
            "question",
            "contestant",
            "cast",
            "oracle",
            "judge",
            "result",
            "breaking",
            "contestants",
            "random",
            "family",
            "speed",
            "plan",
            "film",
            "instructions",
            "theirs",
            "scenes",
            "leaks",
            "asked",
            "plans",
            "summary",
            "plots",
            "provenance",
            "record",
            "run",
            "targets",
        ],
    ),
    (
        "tools/book",
        &["pinhole", "pinhole-course"],
        &[
            "error",
            "edition",
            "course",
            "directive",
            "html",
            "gallery",
            "rasterizer",
            "reference",
            "silhouette",
            "record",
            "worked",
            "figures",
            "formula",
            "interactive",
            "listing",
            "run",
            "scan",
            "expand",
            "build",
            "check",
        ],
    ),
];

#[test]
fn packages_import_only_those_below_them() {
    for (folder, allowed, _) in PACKAGES {
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

#[test]
fn modules_import_only_those_below_them() {
    let mut wrong = Vec::new();
    for (folder, _, modules) in PACKAGES {
        let src = root().join(folder).join("src");
        for (module, imported) in imports(&src) {
            let place = |name: &str| modules.iter().position(|module| *module == name);
            let Some(own) = place(&module) else {
                wrong.push(format!("{folder}: {module} is not in the list"));
                continue;
            };
            for other in imported.iter().filter(|other| **other != module) {
                // What is not a module is re-exported at the top.
                if place(other).is_some_and(|other| other > own) {
                    wrong.push(format!(
                        "{folder}: {module} imports {other}, which is above it"
                    ));
                }
            }
        }
    }
    assert_eq!(wrong, Vec::<String>::new());
}

/// For each top module of a crate, what its files name after `crate::`; tests are free.
fn imports(src: &Path) -> BTreeMap<String, Vec<String>> {
    let mut imports: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for path in sources(src) {
        let inside = path.strip_prefix(src).expect("it lies there");
        let module = inside
            .iter()
            .next()
            .expect("it has a name")
            .to_string_lossy();
        let module = module.trim_end_matches(".rs").to_owned();
        let name = path.file_name().expect("it has a name").to_string_lossy();
        let is_test = inside.iter().any(|part| part == "tests") || name == "tests.rs";
        if is_test || ["lib", "main", "program", "testing"].contains(&module.as_str()) {
            continue;
        }
        let text = fs::read_to_string(&path).expect("sources are text");
        // Unit tests stand at the end of a file.
        let text = text.split("#[cfg(test)]").next().unwrap_or_default();
        let code = text
            .lines()
            .filter(|line| !line.trim_start().starts_with("//"));
        let named = imports.entry(module).or_default();
        for line in code {
            let mut rest = line;
            while let Some(at) = rest.find("crate::") {
                rest = &rest[at + "crate::".len()..];
                let names = rest
                    .trim_start_matches('{')
                    .split(|c: char| "{}".contains(c))
                    .next();
                for name in names.unwrap_or_default().split(", ") {
                    let is_letter = |c: char| c.is_alphanumeric() || c == '_';
                    let end = name.find(|c| !is_letter(c)).unwrap_or(name.len());
                    named.push(name[..end].to_owned());
                }
            }
        }
    }
    imports
}

/// The Rust files in a folder and below.
fn sources(folder: &Path) -> Vec<std::path::PathBuf> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).expect("it can be read").flatten() {
        let path = entry.path();
        match path.is_dir() {
            true => found.extend(sources(&path)),
            false => found.push(path),
        }
    }
    found.retain(|path| path.extension().is_some_and(|end| end == "rs"));
    found
}
