//! Finds lines of the reference's answers in the students' edition, including its
//! search index.

use std::fs;
use std::path::Path;

use pinhole_course::assignment::Assignment;
use pinhole_course::checkout::Checkout;

use super::pages::files;
use crate::error::{Error, Problem, ProblemAndRemedy, Result};
use crate::listing::between;

/// Shorter lines, such as `return None;` or a brace, give nothing away.
const LEAST: usize = 16;

/// A line of an answer, in the forms that are compared.
pub struct Line {
    task: String,
    /// The line in the answer.
    text: String,
    /// The line without spaces.
    bare: String,
}

/// The lines of all answers that would give something away.
pub fn answers(assignment: &Assignment, checkout: &Checkout) -> Result<Vec<Line>> {
    let mut lines = Vec::new();
    for task in &assignment.tasks {
        let file = assignment.reference().join("src").join(task.file());
        let text = checkout.read(&file)?;
        let bodies = bodies(&text)
            .map_err(|(problem, remedy)| Problem::of(checkout.inside(&file), problem, remedy))?;
        let handout = checkout.read(assignment.handout().join("src").join(task.file()))?;
        for line in bodies.lines().map(str::trim) {
            let bare = bare(line);
            // Identifiers are not secret, because the appendix lists them.
            let tells = bare.chars().count() >= LEAST && !line.starts_with("use ");
            if tells && !handout.contains(line) {
                lines.push(Line {
                    task: task.name.clone(),
                    text: line.into(),
                    bare,
                });
            }
        }
    }
    Ok(lines)
}

/// The bodies of all functions of a task.
fn bodies(text: &str) -> std::result::Result<String, ProblemAndRemedy> {
    let mut bodies = between(text, "answer")?;
    let mut rest = text;
    while let Some((_, after)) = rest.split_once("// ANCHOR_END: answer") {
        rest = after;
        if rest.contains("// ANCHOR: answer") {
            bodies += &between(rest, "answer")?;
        }
    }
    Ok(bodies)
}

/// The places in a folder's files that contain one of these lines.
pub fn shown(lines: &[Line], folder: &Path) -> Result<Vec<Problem>> {
    let mut problems = Vec::new();
    for path in files(folder)? {
        let is_text = path
            .extension()
            .and_then(|end| end.to_str())
            .is_some_and(|end| ["html", "js", "json", "svg", "txt"].contains(&end));
        if !is_text {
            continue;
        }
        let text = fs::read_to_string(&path).map_err(|error| Error::file(&path, &error))?;
        let text = bare(&unescaped(&text));
        for line in lines.iter().filter(|line| text.contains(&line.bare)) {
            let file = path.strip_prefix(folder).unwrap_or(&path);
            let problem = format!(
                "it shows a line of the answer to {}: `{}`",
                line.task, line.text
            );
            let remedy = "put it between {{#instructor}} and {{/instructor}}";
            problems.push(Problem::of(
                Path::new("student").join(file),
                problem,
                remedy,
            ));
        }
    }
    Ok(problems)
}

/// Decodes the escapes of HTML and of strings in scripts.
fn unescaped(text: &str) -> String {
    [
        ("\\n", " "),
        ("\\t", " "),
        ("\\\"", "\""),
        ("&lt;", "<"),
        ("&gt;", ">"),
        ("&quot;", "\""),
        ("&#39;", "'"),
        ("&#x27;", "'"),
        ("&amp;", "&"),
    ]
    .iter()
    .fold(text.to_owned(), |text, (from, to)| text.replace(from, to))
}

fn bare(text: &str) -> String {
    text.chars().filter(|c| !c.is_whitespace()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::course::assignment;

    fn found(file: &str, text: &str) -> usize {
        let checkout = Checkout::find().unwrap();
        let assignment = assignment(&checkout).unwrap();
        let lines = answers(&assignment, &checkout).unwrap();
        assert!(
            lines.len() > 20,
            "only {} lines give something away",
            lines.len()
        );
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join(file), text).unwrap();
        shown(&lines, folder.path()).unwrap().len()
    }

    #[test]
    fn a_file_of_two_functions_has_two_answers() {
        let body = |line| format!("// ANCHOR: answer\n{line}\n// ANCHOR_END: answer\n");
        let text = body("first") + "fn join() {\n" + &body("second");
        assert_eq!(bodies(&text).unwrap(), "first\nsecond\n");
    }

    #[test]
    fn a_line_of_an_answer_is_found_in_pages_and_in_the_search_index() {
        let line = "if discriminant < 0.0 {";
        assert_eq!(
            found(
                "a.html",
                &format!("<code>{}</code>", line.replace('<', "&lt;"))
            ),
            1
        );
        assert_eq!(
            found(
                "searchindex.js",
                &format!("{{\"body\":\"x\\n  {line}\\n\"}}")
            ),
            1
        );
        assert_eq!(
            found(
                "a.html",
                "<p>If the discriminant is negative, nothing is met.</p>"
            ),
            0
        );
    }
}
