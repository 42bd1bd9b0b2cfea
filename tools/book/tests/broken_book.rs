//! A small book in which everything is wrong, so that every check of a page is seen to fail.

use std::fs;
use std::path::Path;
use std::sync::Arc;

use pinhole_book::build::{BuiltEdition, build};
use pinhole_book::check::{Part, check};
use pinhole_book::edition::Edition;
use pinhole_book::expand::Sources;
use pinhole_book::run::Runner;
use pinhole_book::worked::Values;
use pinhole_course::checkout::Checkout;
use tempfile::TempDir;

const SUMMARY: &str = "# Summary\n\n- [Dot](dot.md)\n";

/// The assignment's answer and stub.
const ANSWER: &str = "// ANCHOR: answer\nlet product = a.x * b.x + a.y * b.y;\n\
                      // ANCHOR_END: answer\n";
const STUB: &str = "// ANCHOR: stub\ntodo!()\n// ANCHOR_END: stub\n\
                    // ANCHOR: empty\n// ANCHOR_END: empty\n\
                    // ANCHOR: endless\nlet endless;\n";

/// A checkout with this page, and with everything that pages need.
fn checkout(page: &str) -> (TempDir, Checkout) {
    let folder = tempfile::tempdir().expect("there is room");
    let assignment = "assignments/ray_casting";
    let files = [
        ("book/book.toml", "[book]\ntitle = \"Small\"\n"),
        ("book/src/SUMMARY.md", SUMMARY),
        ("book/src/dot.md", page),
        (
            "book/commands.toml",
            "[told]\ncommand = \"pinhole check\"\n",
        ),
        (
            &format!("{assignment}/assignment.toml"),
            "title = \"Small\"\nscene = []\n\
             [[task]]\nname = \"dot\"\nkind = \"first_hit\"\nchapter = \"Dot\"\npoints = []\n",
        ),
        (&format!("{assignment}/handout/src/dot.rs"), STUB),
        (&format!("{assignment}/reference/src/dot.rs"), ANSWER),
        (
            &format!("{assignment}/mistakes/minus/mistake.toml"),
            "belief = \"\"\nfails = [\"dot\"]\nchapter = \"Dot\"\n\
             hint = { look = \"\", think = \"\", read = \"The sum\" }\n",
        ),
    ];
    for (path, text) in files {
        let path = folder.path().join(path);
        fs::create_dir_all(path.parent().expect("it lies in a folder")).expect("there is room");
        fs::write(path, text).expect("there is room");
    }
    let checkout = Checkout::at(folder.path());
    (folder, checkout)
}

fn built(edition: Edition, checkout: &Checkout) -> BuiltEdition {
    let sources = Sources::read(Values::new(), checkout).expect("the small course is whole");
    let out = checkout.root().join("built");
    build(&Arc::new(sources), edition, &out, checkout).expect("mdBook builds it")
}

/// What the check says of a page in the students' edition.
fn told(page: &str) -> Vec<String> {
    let (_folder, checkout) = checkout(page);
    let built = built(Edition::Student, &checkout);
    let problems = check(&[built], &[Part::Pages], &checkout).expect("it looks at all pages");
    let told = problems.iter().map(|problem| problem.problem.clone());
    told.collect()
}

/// The first page is also `index.html`, so a problem may be reported twice.
#[track_caller]
fn assert_told(page: &str, expected: &str) {
    let page = format!("# Dot\n\n## The sum\n\n{page}\n");
    let told = told(&page);
    assert!(
        !told.is_empty() && told.iter().all(|told| told.contains(expected)),
        "{page}\nexpected: {expected}\ngot: {told:?}"
    );
}

#[test]
fn sound_page_has_no_problems() {
    let page = "# Dot\n\n## The sum\n\n[up](#the-sum) $a\\,b$\n\n\
                {{#listing assignments/ray_casting/handout/src/dot.rs:stub}}\n";
    assert_eq!(told(page), Vec::<String>::new());
}

#[test]
fn listings_need_a_file_and_an_anchor_with_lines_and_an_end() {
    let stub = "assignments/ray_casting/handout/src/dot.rs";
    let cases = [
        ("none.rs:stub", "there is no file none.rs"),
        (&format!("{stub}:gone"), "there is no anchor `gone`"),
        (&format!("{stub}:empty"), "nothing is in the anchor"),
        (&format!("{stub}:endless"), "has no end"),
    ];
    for (listing, expected) in cases {
        assert_told(&format!("{{{{#listing {listing}}}}}"), expected);
    }
}

#[test]
fn runs_values_and_figures_must_be_there() {
    assert_told("{{#run unknown}}", "there is no command `unknown`");
    assert_told("{{#run told}}", "was never captured");
    assert_told("{{#value unknown}}", "there is no value `unknown`");
    assert_told(
        "{{#figure unknown \"A ray\" \"A ray.\"}}",
        "there is no figure `unknown`",
    );
    assert_told("{{#gallery dot}}", "the gallery of dot was never made");
}

#[test]
fn no_directive_is_left_as_it_was_written() {
    assert_told("`{{#value slide_u}}`", "is inside code");
}

#[test]
fn links_and_anchors_must_lead_somewhere() {
    assert_told("[gone](gone.md)", "there is no such page or file");
    assert_told("[gone](#gone)", "the page has no anchor `gone`");
    assert_told("[Dot](dot.md) shows it.", "the link names no section");
}

#[test]
fn images_need_a_text() {
    assert_told("<img src=\"book.js\" alt=\"\">", "has no alternative text");
}

#[test]
fn a_section_that_a_mistake_sends_to_must_be_there() {
    let told = told("# Dot\n");
    assert_eq!(told, ["`Dot` has no section `The sum`"]);
}

#[test]
fn students_see_no_solution_and_instructors_do() {
    let listing = "{{#listing assignments/ray_casting/reference/src/dot.rs:answer}}";
    assert_told(listing, "is a solution");
    let typed = "```rust\nlet product = a.x*b.x + a.y*b.y;\n```";
    assert_told(typed, "shows a line of the answer to dot");
    let page =
        format!("# Dot\n\n## The sum\n\n{{{{#instructor}}}}\n{listing}\n{{{{/instructor}}}}\n");
    assert_eq!(told(&page), Vec::<String>::new());
    let (_folder, checkout) = checkout(&page);
    let built = built(Edition::Instructor, &checkout);
    let html = fs::read_to_string(built.folder.join(Path::new("dot.html"))).expect("it is built");
    assert!(html.contains("product"), "{html}");
}

#[test]
#[cfg(unix)]
fn a_command_that_prints_something_else_now_is_a_problem_at_its_line() {
    let (_folder, checkout) = checkout("# Dot\n");
    // It prints its arguments: the command, and the folder of answers under its name here.
    let runner = Runner::of("/bin/echo".into(), &checkout);
    let told = || -> Vec<(Option<usize>, String)> {
        let problems = runner.changed().expect("it runs").into_iter();
        problems
            .map(|problem| (problem.line, problem.problem))
            .collect()
    };
    let keep = |text: &str| {
        let captured = checkout.book().join("captured");
        fs::create_dir_all(&captured).expect("there is room");
        fs::write(captured.join("told.txt"), text).expect("there is room");
    };
    let one = |line: Option<usize>, text: &str| vec![(line, text.to_owned())];
    assert_eq!(told(), one(None, "the command was never captured"));
    keep("check assignments/ray_casting/handout\n");
    assert!(told().is_empty());
    keep("grade assignments/ray_casting/handout\n");
    let changed = "the command now prints `check assignments/ray_casting/handout`, not \
                   `grade assignments/ray_casting/handout`";
    assert_eq!(told(), one(Some(1), changed));
}
