//! Checks that the chapters and sections which `check` and the report name exist.

use pinhole_course::assignment::Assignment;
use pinhole_course::checkout::Checkout;
use pinhole_course::mistake::MistakeFolder;

use super::pages::{Page, Pages};
use crate::error::Problem;

/// Chapters and sections that tasks and mistakes name, but the book doesn't have.
pub fn missing(
    pages: &Pages,
    assignment: &Assignment,
    mistakes: &[MistakeFolder],
    checkout: &Checkout,
) -> Vec<Problem> {
    let mut problems = Vec::new();
    for task in &assignment.tasks {
        if chapter(pages, &task.chapter).is_none() {
            let problem = format!(
                "task {} names a missing chapter `{}`",
                task.name, task.chapter
            );
            let file = checkout.inside(&assignment.folder.join("assignment.toml"));
            problems.push(Problem::of(file, problem, "write it, or correct the name"));
        }
    }
    for MistakeFolder {
        folder, mistake, ..
    } in mistakes
    {
        let file = checkout.inside(&folder.join("mistake.toml"));
        let title = &mistake.chapter;
        let section = &mistake.hint.read;
        match chapter(pages, title) {
            None => {
                let problem = format!("there is no chapter `{title}`");
                problems.push(Problem::of(file, problem, "write it, or correct the name"));
            }
            Some(page) if !page.headings.contains(section) => {
                let problem = format!("`{title}` has no section `{section}`");
                problems.push(Problem::of(file, problem, "write it, or correct the name"));
            }
            Some(_) => {}
        }
    }
    problems
}

fn chapter<'a>(pages: &'a Pages, title: &str) -> Option<&'a Page> {
    pages
        .values()
        .find(|page| page.headings.first().is_some_and(|first| first == title))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::course::assignment;

    #[test]
    fn a_chapter_or_section_that_a_mistake_names_must_be_a_heading() {
        let text = "<main><h1>Sphere</h1><h2>Which root counts</h2></main>";
        let pages = Pages::from([("sphere.html".into(), Page::parse(text))]);
        let checkout = Checkout::find().unwrap();
        let mut assignment = assignment(&checkout).unwrap();
        assignment.tasks.retain(|task| task.name == "plane");
        let mistake = |chapter: &str, read: &str| {
            let text = format!(
                "belief = \"\"\nfails = []\nchapter = \"{chapter}\"\n\
                 hint = {{ look = \"\", think = \"\", read = \"{read}\" }}"
            );
            MistakeFolder {
                slug: chapter.into(),
                folder: chapter.into(),
                mistake: toml::from_str(&text).unwrap(),
            }
        };
        let mistakes = [
            mistake("Sphere", "Which root counts"),
            mistake("Sphere", "Which roots count"),
            mistake("Cone", "The tip"),
        ];
        let told: Vec<String> = missing(&pages, &assignment, &mistakes, &checkout)
            .into_iter()
            .map(|problem| problem.problem)
            .collect();
        let expected = [
            "task plane names a missing chapter `Plane`",
            "`Sphere` has no section `Which roots count`",
            "there is no chapter `Cone`",
        ];
        assert_eq!(told, expected);
    }
}
