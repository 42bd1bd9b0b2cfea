//! The page of each task has everything that such a page needs, in reading order.

use pinhole_book::course::assignments;
use pinhole_course::assignment::Assignment;
use pinhole_course::checkout::Checkout;
use pinhole_course::mistake;

/// What the page of a task must have: the question, a picture, the derivation and worked numbers
/// under headings of its own, then the stub, pictures of mistakes, the command, and questions.
fn parts(assignment: &Assignment, task: &str) -> Vec<String> {
    let parts = [
        "\n**",
        "{{#figure ",
        "\n$$",
        "{{#value ",
        "{{#listing assignments/ASSIGNMENT/handout/src/TASK.rs:stub}}",
        "\n## If your picture looks like this\n",
        "{{#gallery TASK}}",
        "\n## Try it\n",
        "{{#run check_TASK}}",
        "\n<details><summary>",
        "\n<details><summary>",
        "\n<details><summary>",
        "\n## Open challenges\n",
        "\n## For the curious: the numerics\n",
    ];
    let mistakes = mistake::read_all(assignment).expect("they can be read");
    let is_shown = |part: &&str| !mistakes.is_empty() || !GALLERY.contains(part);
    let parts = parts.into_iter().filter(is_shown).map(|part| {
        let part = part.replace("TASK", task);
        part.replace("ASSIGNMENT", &assignment.name)
    });
    parts.collect()
}

/// What the page of a task needs if mistakes of its assignment are known.
const GALLERY: [&str; 2] = [
    "\n## If your picture looks like this\n",
    "{{#gallery TASK}}",
];

/// The first part that does not follow those before it.
fn missing(page: &str, parts: &[String]) -> Option<String> {
    let mut rest = page;
    for part in parts {
        match rest.find(part) {
            Some(at) => rest = &rest[at + part.len() - 1..],
            None => return Some(part.clone()),
        }
    }
    None
}

#[test]
fn every_steps_page_has_each_part_in_order() {
    let checkout = Checkout::find().expect("tests run in a checkout");
    let assignments = assignments(&checkout).expect("they are there");
    let tasks = assignments.iter().flat_map(|assignment| {
        let tasks = assignment.tasks.iter();
        tasks.map(move |task| (task, parts(assignment, &task.name)))
    });
    let mut pages = 0;
    for (task, parts) in tasks {
        let page = task.chapter.to_lowercase().replace(' ', "_");
        let page = checkout.read(format!("book/src/{page}.md")).expect(&page);
        assert_eq!(missing(&page, &parts), None, "{}", task.chapter);
        pages += 1;
        // A page without one of the parts is reported.
        for part in &parts {
            let at = page.rfind(part).expect("it was found");
            let without = format!("{}{}", &page[..at], &page[at + part.len()..]);
            let needed = parts.iter().filter(|it| *it == part).count();
            if without.matches(part).count() < needed {
                assert!(missing(&without, &parts).is_some(), "{part}");
            }
        }
    }
    assert!(pages >= 10, "only {pages} pages were looked at");
}
