//! Imports between the modules of a package point one way, and so do those between the
//! modules of a large folder.
//!
//! A module may import those before it in its folder's list. Insert a new module where its
//! imports allow.

use std::collections::BTreeMap;
use std::fs;

use pinhole_testing::root;

use crate::{is_test, sources};

/// Folders of modules, and the modules of each from the bottom up.
const FOLDERS: [(&str, &[&str]); 8] = [
    (
        "src",
        &[
            "error",
            "counter",
            "fact",
            "ray",
            "part",
            "words",
            "camera",
            "bounds",
            "tree",
            "film",
            "mesh",
            "source",
            "shape",
            "scene",
            "kind",
            "job",
            "serve",
            "ask",
            "preview",
            "judge",
            "comparison",
            "report",
            "oiiotool",
            "false_colour",
            "heat_map",
        ],
    ),
    (
        "tools/course/src",
        &[
            "error",
            "private",
            "link",
            "output",
            "shell",
            "timings",
            "checkout",
            "rust_tool",
            "progress",
            "seed",
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
            "mistake_films",
            "examples",
        ],
    ),
    (
        "tools/report/src",
        &[
            "desktop", "escape", "passage", "program", "pictures", "finish", "cast", "terminal",
            "json", "html",
        ],
    ),
    (
        "tools/cli/src",
        &["cli", "programs", "version", "watch", "command"],
    ),
    (
        "tools/instructor/src",
        &[
            "scene_cap",
            "golden",
            "validate",
            "grade",
            "handout",
            "cli",
            "command",
        ],
    ),
    (
        "tools/instructor/src/grade",
        &[
            "atomic",
            "redact",
            "provenance",
            "evidence",
            "record",
            "points",
            "intake",
            "policy",
            "shared_answers",
            "unexplained_groups",
            "cache",
            "class",
            "grader",
            "views",
            "queue",
            "stored",
        ],
    ),
    (
        "tools/study/src",
        &[
            "extent",
            "number",
            "vector",
            "double_double",
            "dyadic",
            "root",
            "shape",
            "kernel",
            "question",
            "random",
            "cast",
            "oracle",
            "contestants",
            "conditioning",
            "judge",
            "result",
            "family",
            "speed",
            "leaks",
            "plan",
            "random_scene",
            "secondary",
            "scenes",
            "embree",
            "classes",
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
        "tools/book/src",
        &[
            "error",
            "edition",
            "course",
            "directive",
            "html",
            "png",
            "gallery",
            "rasterizer",
            "reference",
            "silhouette",
            "boxes",
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
fn modules_import_only_those_below_them() {
    let mut wrong = Vec::new();
    for (folder, modules) in FOLDERS {
        for (module, imported) in imports(folder) {
            let place = |name: &str| modules.iter().position(|module| *module == name);
            let Some(own) = place(&module) else {
                wrong.push(format!("{folder}: {module} is not in the list"));
                continue;
            };
            for other in imported.iter().filter(|other| **other != module) {
                // A name that is not a module is re-exported at the top.
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

/// For each module of a folder, the names that follow the folder's own path in its files, as in
/// `crate::NAME` or `super::NAME`. Tests may import anything.
fn imports(folder: &str) -> BTreeMap<String, Vec<String>> {
    let (_, inner) = folder.split_once("src").expect("sources lie there");
    let absolute = format!("crate{}::", inner.replace('/', "::"));
    let folder = root().join(folder);
    let mut imports: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for path in sources(&folder) {
        let inside = path.strip_prefix(&folder).expect("it is in that folder");
        let module = inside
            .iter()
            .next()
            .expect("it has a name")
            .to_string_lossy();
        let module = module.trim_end_matches(".rs").to_owned();
        if is_test(inside) || ["lib", "main", "program"].contains(&module.as_str()) {
            continue;
        }
        let text = fs::read_to_string(&path).expect("sources are text");
        // Unit tests are at the end of a file.
        let text = text.split("#[cfg(test)]").next().unwrap_or_default();
        let code = text
            .lines()
            .filter(|line| !line.trim_start().starts_with("//"));
        let relative = "super::".repeat(inside.iter().count());
        let named = imports.entry(module).or_default();
        for line in code {
            named.extend(names_after(&absolute, line));
            named.extend(names_after(&relative, line));
        }
    }
    imports
}

/// The names that follow a path in a line: one, or several in braces.
fn names_after(path: &str, line: &str) -> Vec<String> {
    let is_letter = |c: char| c.is_alphanumeric() || c == '_';
    let names = line.split(path).skip(1).flat_map(|rest| {
        let (list, most) = match rest.strip_prefix('{') {
            Some(list) => (
                list.split(['{', '}']).next().unwrap_or_default(),
                usize::MAX,
            ),
            None => (rest, 1),
        };
        list.split(", ").take(most)
    });
    let first_word = |name: &str| name.split(|c| !is_letter(c)).next().map(str::to_owned);
    names.filter_map(first_word).collect()
}

#[test]
fn an_import_is_found_in_every_notation() {
    let found = |line| names_after("crate::grade::", line);
    assert_eq!(found("use crate::grade::views::csv;"), ["views"]);
    assert_eq!(
        found("use crate::grade::{cache, views::csv};"),
        ["cache", "views"]
    );
    assert_eq!(
        found("x(crate::grade::record::a, crate::grade::class::b)"),
        ["record", "class"]
    );
    assert_eq!(found("use crate::golden::arguments;"), Vec::<String>::new());
}
