//! A student's README: words of its own from a template, the course's sections for
//! students, and what is worth what.

use super::Files;
use pinhole_course::assignment::{Assignment, ScenePoints};
use pinhole_course::error::{Error, Result};

const TEMPLATE: &str = include_str!("../../templates/handout/README.md");

/// In the template, a line that stands for a section: this, and the section's heading.
const QUOTED: &str = "<!-- quoted: ";

/// The line that stands for what each task is worth, and the word that stands for the
/// names of the answer files.
const POINTS: &str = "<!-- points -->";
const ANSWERS: &str = "<!-- answers -->";

/// In the template, a line that is for those who get the book: this, and the line.
const BOOK: &str = "<!-- book -->";

/// Replaces the course's README by a student's.
pub fn adapt(files: &mut Files, assignment: &Assignment) -> Result<()> {
    let answers: Vec<String> = assignment.tasks.iter().map(|task| task.file()).collect();
    let template = TEMPLATE
        .replace(POINTS, points(assignment).trim_end())
        .replace(ANSWERS, &answers.join(" "));
    let has_book = files.keys().any(|path| path == "book/index.html");
    let mut missing = None;
    let readme = files
        .get("README.md")
        .map(|bytes| String::from_utf8_lossy(bytes));
    let readme = readme.unwrap_or_default().replace("\r\n", "\n");
    let mut text = String::new();
    {
        for line in template.lines() {
            let line = match line.strip_prefix(BOOK) {
                Some(_) if !has_book => continue,
                Some(rest) => rest,
                None => line,
            };
            let heading = line
                .strip_prefix(QUOTED)
                .and_then(|rest| rest.strip_suffix(" -->"));
            match heading.map(|heading| (heading, section(&readme, heading))) {
                Some((_, Some(section))) => text.push_str(section.trim_end()),
                Some((heading, None)) => missing = Some(heading),
                None => text.push_str(line),
            }
            text.push('\n');
        }
    }
    files.insert("README.md".into(), text.into());
    match missing {
        None => Ok(()),
        Some(heading) => Err(Error::input(
            format!("README.md has no section `{heading}` for students"),
            "restore it, or mend tools/instructor/templates/handout/README.md, which quotes it",
        )),
    }
}

/// What each task is worth, and all scenes, as a table.
fn points(assignment: &Assignment) -> String {
    let mut table = "| answer | points |\n| --- | --- |\n".to_owned();
    for task in &assignment.tasks {
        let worth: u32 = task.points.iter().map(|group| group.worth).sum();
        table.push_str(&format!("| `{}` | {worth} |\n", task.file()));
    }
    let (public, withheld): (Vec<_>, Vec<_>) =
        assignment.scenes.iter().partition(|scene| scene.public);
    let sum = |scenes: &[&ScenePoints]| scenes.iter().map(|scene| scene.points).sum::<u32>();
    let row = format!(
        "| all of them together, in {} scenes | {} |\n",
        public.len(),
        sum(&public)
    );
    table.push_str(&row);
    if !withheld.is_empty() {
        let row = format!("| scenes that come with grading | {} |\n", sum(&withheld));
        table.push_str(&row);
    }
    table
}

/// A section with its heading, or, named `beginning`, all that precedes the first.
fn section<'a>(readme: &'a str, heading: &str) -> Option<&'a str> {
    let start = match heading {
        "beginning" => 0,
        _ => readme.find(&format!("\n## {heading}\n"))? + 1,
    };
    let text = &readme[start..];
    let end = text[1..].find("\n## ").map_or(text.len(), |end| end + 2);
    Some(&text[..end])
}
