//! Code between two anchors of a real file.

use std::path::Path;

use pinhole_course::checkout::Checkout;

use crate::edition::Edition;
use crate::error::ProblemAndRemedy;

/// Folders of code that gives an answer away.
const SOLUTIONS: [&str; 3] = ["/reference/", "/variants/", "/mistakes/"];

/// Markdown of a listing, with the file's path above it.
pub fn listing(
    path: &str,
    anchor: &str,
    edition: Edition,
    checkout: &Checkout,
) -> Result<String, ProblemAndRemedy> {
    let is_solution = SOLUTIONS.iter().any(|folder| path.contains(folder));
    if is_solution && edition == Edition::Student {
        return Err((
            format!("{path} is a solution, and this is the students' edition"),
            "put it between {{#instructor}} and {{/instructor}}".into(),
        ));
    }
    let text = checkout.read(path).map_err(|_| {
        let remedy = "give its path from the top of the checkout";
        (format!("there is no file {path}"), remedy.into())
    })?;
    let code = between(&text, anchor)
        .map_err(|(problem, remedy)| (format!("{path}: {problem}"), remedy))?;
    let language = match Path::new(path).extension().and_then(|end| end.to_str()) {
        Some("rs") => "rust,noplayground",
        Some(other) => other,
        None => "text",
    };
    let fence = fence(&code);
    Ok(format!(
        "<figure class=\"listing\">\n<figcaption><code>{path}</code></figcaption>\n\n\
         {fence}{language}\n{code}{fence}\n\n</figure>\n"
    ))
}

/// The lines between an anchor and its end, without markers of other anchors and without common
/// indentation.
pub fn between(text: &str, anchor: &str) -> Result<String, ProblemAndRemedy> {
    let (open, close) = (
        format!("// ANCHOR: {anchor}"),
        format!("// ANCHOR_END: {anchor}"),
    );
    let mut inside: Option<Vec<&str>> = None;
    for line in text.lines() {
        let marker = line.trim();
        if marker == open && inside.is_some() {
            let remedy = "give each part a name of its own";
            return Err((format!("the anchor `{anchor}` begins twice"), remedy.into()));
        } else if marker == open {
            inside = Some(Vec::new());
        } else if let Some(lines) = inside.as_mut().filter(|_| marker != close) {
            if !marker.starts_with("// ANCHOR") {
                lines.push(line);
            }
        } else if let Some(lines) = &inside {
            return match lines.iter().all(|line| line.trim().is_empty()) {
                true => Err((
                    format!("nothing is in the anchor `{anchor}`"),
                    "move the markers around what is to be shown".into(),
                )),
                false => Ok(to_the_left(lines)),
            };
        }
    }
    Err(match inside {
        Some(_) => (
            format!("the anchor `{anchor}` has no end"),
            format!("put `{close}` where it ends"),
        ),
        None => (
            format!("there is no anchor `{anchor}`"),
            format!("put `{open}` where it begins, and `{close}` where it ends"),
        ),
    })
}

fn to_the_left(lines: &[&str]) -> String {
    let indent = |line: &&str| line.len() - line.trim_start().len();
    let written = lines.iter().filter(|line| !line.trim().is_empty());
    let common = written.map(indent).min().unwrap_or(0);
    let moved = lines.iter().map(|line| line.get(common..).unwrap_or(""));
    moved.map(|line| format!("{line}\n")).collect()
}

/// More backticks than any line of `text` begins with.
pub fn fence(text: &str) -> String {
    let ticks = |line: &str| line.len() - line.trim_start_matches('`').len();
    let most = text.lines().map(|line| ticks(line.trim_start())).max();
    "`".repeat(most.unwrap_or(0).max(2) + 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    const FILE: &str = "a\n// ANCHOR: one\n    b\n        // ANCHOR: two\n        c\n        \
                        // ANCHOR_END: two\n// ANCHOR_END: one\n// ANCHOR: empty\n\n\
                        // ANCHOR_END: empty\n// ANCHOR: endless\nd\n";

    #[test]
    fn a_listing_is_the_text_between_its_markers() {
        assert_eq!(between(FILE, "one").unwrap(), "b\n    c\n");
        assert_eq!(between(FILE, "two").unwrap(), "c\n");
    }

    #[test]
    fn a_missing_an_empty_and_an_endless_anchor_are_errors() {
        for (anchor, problem) in [
            ("three", "there is no anchor `three`"),
            ("empty", "nothing is in the anchor `empty`"),
            ("endless", "the anchor `endless` has no end"),
        ] {
            assert_eq!(between(FILE, anchor).unwrap_err().0, problem);
        }
    }

    #[test]
    fn a_solution_is_refused_in_the_students_edition() {
        let path = "assignments/ray_casting/reference/src/sphere.rs";
        let checkout = Checkout::find().unwrap();
        let shown = |edition| listing(path, "answer", edition, &checkout);
        assert!(
            shown(Edition::Student)
                .unwrap_err()
                .0
                .contains("is a solution")
        );
        assert!(shown(Edition::Instructor).unwrap().contains("discriminant"));
    }
}
