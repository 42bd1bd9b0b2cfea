//! Imports point one way: between packages, and between the modules of each.
//!
//! A package may import those before it in [`PACKAGES`], a module those before it in its
//! package's list. A new module goes into the list where its imports allow.
//!
//! And the tools and the seam of the harness take assignments, tasks and shapes as data: no
//! source of theirs names one.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use pinhole_testing::root;
use proc_macro2::{TokenStream, TokenTree};

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
            "desktop", "escape", "passage", "program", "pictures", "cast", "terminal", "json",
            "html",
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

/// Sources that take assignments, tasks and shapes as data: folders, and the beginnings of
/// files' names.
const NAMELESS: [&str; 8] = [
    "tools/course/src",
    "tools/report/src",
    "tools/cli/src",
    "tools/instructor/src",
    "src/serve",
    "src/ask",
    "src/job",
    "src/judge",
];

/// Where assignments lie, the tests' own among them.
const ASSIGNMENTS: [&str; 2] = ["assignments", "tools/instructor/tests/fixture/assignments"];

/// Fields of shapes, but for `point` and `normal`, which are words of any geometry.
const FIELDS: [&str; 5] = ["center", "radius", "corners", "obj", "triangles"];

/// Where a name is part of a term that has nothing to do with the task.
const TERMS: [&str; 4] = ["image plane", "image_plane", "disk space", "on a disk"];

#[test]
fn no_assignment_task_or_shape_is_named_where_all_are_data() {
    let names = Names::read();
    let all = ["src", "tools"].map(|folder| sources(&root().join(folder)));
    let mut wrong = Vec::new();
    let mut looked_at = 0;
    for path in all.concat() {
        let inside = path.strip_prefix(root()).expect("it lies there");
        let file = inside.to_string_lossy().replace('\\', "/");
        let is_nameless = NAMELESS.iter().any(|start| file.starts_with(start));
        if !is_nameless || is_test(inside) {
            continue;
        }
        looked_at += 1;
        let text = fs::read_to_string(&path).expect("sources are text");
        let named = names.named_in(&text);
        wrong.extend(named.into_iter().map(|it| format!("{file}: {it}")));
    }
    assert!(looked_at > 100, "only {looked_at} files");
    assert_eq!(wrong, Vec::<String>::new());
}

#[test]
fn a_name_is_found_in_code_and_strings_but_not_in_comments_and_tests() {
    let names = Names::read();
    for named in [
        "fn f() { sphere_of(x) }",
        "const X: ShapeKind = ShapeKind::Sphere;",
        "fn f() { read(\"golden/ray_casting\") }",
        "fn f(c: C) { println!(\"{}\", c.radius) }",
        "fn f() { ask(\"first_hit\") }",
        "/// Words.\n#[cfg(test)]\nmod tests { }\nfn disk() {}",
    ] {
        assert_eq!(names.named_in(named).len(), 1, "{named}");
    }
    for nameless in [
        "//! Spheres.\n//! A sphere.\n",
        "/// A sphere.\nfn f() { /* a sphere */ g(Kind::FirstHit) } // sphere",
        "#[cfg(test)]\nmod tests { fn sphere() {} }",
        "#[cfg(test)]\nuse a::sphere;\nfn f() {}",
        "fn f() { say(\"on the image plane\"); atmosphere(hemispheres) }",
    ] {
        assert_eq!(names.named_in(nameless), Vec::<String>::new(), "{nameless}");
    }
}

/// What must not be named.
struct Names {
    /// In snake case.
    names: BTreeSet<String>,
    /// Those that are the name of a kind of question too: the kind itself may be named, in
    /// camel case.
    kinds: BTreeSet<String>,
}

impl Names {
    /// Of all assignments there are.
    fn read() -> Names {
        let mut names: BTreeSet<String> = FIELDS.iter().map(|it| it.to_string()).collect();
        let mut kinds = BTreeSet::new();
        for folder in ASSIGNMENTS {
            let entries = fs::read_dir(root().join(folder)).expect("it can be read");
            for entry in entries.flatten() {
                let path = entry.path().join("assignment.toml");
                let Ok(text) = fs::read_to_string(path) else {
                    continue;
                };
                names.insert(entry.file_name().into_string().expect("a plain name"));
                let file: toml::Table = text.parse().expect("it is TOML");
                for task in file["task"].as_array().expect("a list") {
                    let word = |key: &str| task[key].as_str().expect("it is text").to_owned();
                    names.insert(word("name"));
                    kinds.insert(word("kind"));
                }
            }
        }
        Names { names, kinds }
    }

    /// The words of a source's code and strings that hold a name.
    fn named_in(&self, text: &str) -> Vec<String> {
        let tokens: TokenStream = text.parse().expect("sources are Rust");
        let mut words = Vec::new();
        collect_words(tokens, &mut words);
        words.retain(|word| self.are_in(word));
        words
    }

    /// Whether a word holds a name as a whole part of it, as `sphere_of` holds `sphere`.
    fn are_in(&self, word: &str) -> bool {
        let is_camel = word.starts_with(char::is_uppercase);
        let mut snake = String::from("_");
        for (k, letter) in word.char_indices() {
            if is_camel && letter.is_uppercase() && k > 0 {
                snake.push('_');
            }
            snake.extend(letter.to_lowercase());
        }
        snake.push('_');
        let is_kind = |name: &String| is_camel && self.kinds.contains(name);
        let mut names = self.names.iter().filter(|name| !is_kind(name));
        names.any(|name| snake.contains(&format!("_{name}_")))
    }
}

/// Identifiers, and words of literals, without comments, documentation and items that are
/// there for tests alone.
fn collect_words(tokens: TokenStream, words: &mut Vec<String>) {
    let mut tokens = tokens.into_iter().peekable();
    while let Some(token) = tokens.next() {
        match token {
            TokenTree::Punct(punct) if punct.as_char() == '#' => {
                // `#!` of a whole file.
                let is_bang = |token: &TokenTree| matches!(token, TokenTree::Punct(it) if it.as_char() == '!');
                tokens.next_if(is_bang);
                let attribute = match tokens.peek() {
                    Some(TokenTree::Group(group)) => group.stream().to_string(),
                    _ => continue,
                };
                let attribute = attribute.replace(' ', "");
                if attribute.starts_with("doc=") || attribute == "cfg(test)" {
                    tokens.next();
                }
                if attribute == "cfg(test)" {
                    let is_end = |token: &TokenTree| match token {
                        TokenTree::Group(group) => {
                            group.delimiter() == proc_macro2::Delimiter::Brace
                        }
                        TokenTree::Punct(punct) => punct.as_char() == ';',
                        _ => false,
                    };
                    tokens.by_ref().find(is_end);
                }
            }
            TokenTree::Group(group) => collect_words(group.stream(), words),
            TokenTree::Ident(ident) => words.push(without_terms(&ident.to_string())),
            TokenTree::Literal(literal) => {
                let text = without_terms(&literal.to_string());
                let is_letter = |c: char| c.is_alphanumeric() || c == '_';
                words.extend(text.split(|c| !is_letter(c)).map(str::to_owned));
            }
            TokenTree::Punct(_) => {}
        }
    }
}

fn without_terms(text: &str) -> String {
    let remove = |text: String, term: &&str| text.replace(*term, "");
    TERMS.iter().fold(text.to_owned(), remove)
}

/// Whether a file is there for tests alone.
fn is_test(inside: &Path) -> bool {
    let test = ["tests", "tests.rs", "testing", "testing.rs"];
    inside.iter().any(|part| test.iter().any(|it| part == *it))
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
        if is_test(inside) || ["lib", "main", "program"].contains(&module.as_str()) {
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
fn sources(folder: &Path) -> Vec<PathBuf> {
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
