//! Each step's page has what a step's page needs, in the order in which one reads it.

use pinhole_book::course::assignment;
use pinhole_course::checkout::Checkout;

/// What stands on the page of a task: the question, a picture, the derivation and worked
/// numbers, whose sections are its own, then the stub, what mistakes look like, the command,
/// and questions.
fn parts(task: &str) -> Vec<String> {
    let parts = [
        "\n**",
        "{{#figure ",
        "\n$$",
        "{{#value ",
        "{{#listing assignments/ray_casting/handout/src/TASK.rs:stub}}",
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
    let parts = parts.map(|part| part.replace("TASK", task));
    parts.into()
}

/// The first part that does not follow those before it.
fn missing(page: &str, task: &str) -> Option<String> {
    let mut rest = page;
    for part in parts(task) {
        match rest.find(&part) {
            Some(at) => rest = &rest[at + part.len() - 1..],
            None => return Some(part),
        }
    }
    None
}

#[test]
fn every_steps_page_has_each_part_in_order() {
    let checkout = Checkout::find().expect("tests run in a checkout");
    let assignment = assignment(&checkout).expect("it is there");
    assert_eq!(assignment.tasks.len(), 6);
    for task in assignment.tasks {
        let page = task.chapter.to_lowercase().replace(' ', "_");
        let page = checkout.read(format!("book/src/{page}.md")).expect(&page);
        assert_eq!(missing(&page, &task.name), None, "{}", task.chapter);
        // And a page without a part is found out.
        for part in parts(&task.name) {
            let at = page.rfind(&part).expect("it was found");
            let without = format!("{}{}", &page[..at], &page[at + part.len()..]);
            if without.matches(&part).count()
                < parts(&task.name).iter().filter(|it| **it == part).count()
            {
                assert!(missing(&without, &task.name).is_some(), "{part}");
            }
        }
    }
}
