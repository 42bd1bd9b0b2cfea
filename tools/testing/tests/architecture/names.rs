//! The tools, and the part of the harness between them and a submission, take assignments, tasks
//! and shapes as data: none of their sources names one.

use std::collections::BTreeSet;
use std::fs;

use pinhole_testing::root;
use proc_macro2::{TokenStream, TokenTree};

use crate::{is_test, sources};

/// Sources that take assignments, tasks and shapes as data: folders, and beginnings of file
/// names.
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

/// The folders of assignments, including the tests' own.
const ASSIGNMENTS: [&str; 2] = ["assignments", "tools/instructor/tests/fixture/assignments"];

/// Fields of shapes, except `point` and `normal`, which any geometry has.
const FIELDS: [&str; 5] = ["center", "radius", "corners", "obj", "triangles"];

/// Terms that contain the name of a task or an assignment only by chance.
const TERMS: [&str; 4] = ["image plane", "image_plane", "disk space", "on a disk"];

#[test]
fn no_tool_names_an_assignment_a_task_or_a_shape() {
    let names = ForbiddenNames::read();
    let all = ["src", "tools"].map(|folder| sources(&root().join(folder)));
    let mut wrong = Vec::new();
    let mut looked_at = 0;
    for path in all.concat() {
        let inside = path.strip_prefix(root()).expect("it is in that folder");
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
    let names = ForbiddenNames::read();
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
struct ForbiddenNames {
    /// In snake case.
    names: BTreeSet<String>,
    /// Names that are also kinds of question. The kind itself may be named, in camel case.
    kinds: BTreeSet<String>,
}

impl ForbiddenNames {
    /// The names of all assignments.
    fn read() -> ForbiddenNames {
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
        ForbiddenNames { names, kinds }
    }

    /// The words of a source's code and strings that hold a name.
    fn named_in(&self, text: &str) -> Vec<String> {
        let tokens: TokenStream = text.parse().expect("sources are Rust");
        let mut words = Vec::new();
        collect_words(tokens, &mut words);
        words.retain(|word| self.are_in(word));
        words
    }

    /// Whether a word has a name as a whole part, as `sphere_of` has `sphere`.
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

/// Identifiers, and words of literals, without comments, documentation and items that exist only
/// for tests.
fn collect_words(tokens: TokenStream, words: &mut Vec<String>) {
    let mut tokens = tokens.into_iter().peekable();
    while let Some(token) = tokens.next() {
        match token {
            TokenTree::Punct(punct) if punct.as_char() == '#' => {
                // `#!`, an attribute of a whole file.
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
