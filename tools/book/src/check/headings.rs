//! What `check` and the report send a student to read must be there.

use std::collections::BTreeMap;

use super::pages::{Page, Pages};
use crate::course::{Course, Mistake};
use crate::error::Problem;

/// Chapters and sections that tasks and mistakes name, and that the book has not.
pub fn missing(
    pages: &Pages,
    course: &Course,
    mistakes: &BTreeMap<String, Mistake>,
) -> Vec<Problem> {
    let mut problems = Vec::new();
    for task in &course.task {
        if chapter(pages, &task.chapter).is_none() {
            let problem = format!("task {} names a chapter `{}`", task.name, task.chapter);
            let file = "assignments/ray_casting/assignment.toml";
            problems.push(Problem::of(file, problem, "write it, or correct the name"));
        }
    }
    for (
        slug,
        Mistake {
            chapter: title,
            hint,
            ..
        },
    ) in mistakes
    {
        let file = format!("assignments/ray_casting/mistakes/{slug}/mistake.toml");
        match chapter(pages, title) {
            None => {
                let problem = format!("there is no chapter `{title}`");
                problems.push(Problem::of(file, problem, "write it, or correct the name"));
            }
            Some(page) if !page.headings.contains(&hint.read) => {
                let problem = format!("`{title}` has no section `{}`", hint.read);
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

    #[test]
    fn a_chapter_or_section_that_a_mistake_names_must_be_a_heading() {
        let text = "<main><h1>Sphere</h1><h2>Which root counts</h2></main>";
        let pages = Pages::from([("sphere.html".into(), Page::parse(text))]);
        let course: Course =
            toml::from_str("scene = []\n[[task]]\nname = \"plane\"\nchapter = \"Plane\"").unwrap();
        let mistake = |chapter: &str, read: &str| -> Mistake {
            let text = format!(
                "belief = \"\"\nfails = []\nchapter = \"{chapter}\"\nhint = {{ think = \"\", read = \"{read}\" }}"
            );
            toml::from_str(&text).unwrap()
        };
        let mistakes = BTreeMap::from([
            ("a".to_owned(), mistake("Sphere", "Which root counts")),
            ("b".to_owned(), mistake("Sphere", "Which roots count")),
            ("c".to_owned(), mistake("Cone", "The tip")),
        ]);
        let told: Vec<String> = missing(&pages, &course, &mistakes)
            .into_iter()
            .map(|problem| problem.problem)
            .collect();
        let expected = [
            "task plane names a chapter `Plane`",
            "`Sphere` has no section `Which roots count`",
            "there is no chapter `Cone`",
        ];
        assert_eq!(told, expected);
    }
}
