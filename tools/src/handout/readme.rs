//! A student's README: a short start of its own, and the course's sections for students.

use super::Files;
use super::workspace::change;
use crate::error::{Error, Result};

const TEMPLATE: &str = include_str!("../../templates/handout/README.md");

/// In the template, a line that stands for a section: this, and the section's heading.
const QUOTED: &str = "<!-- quoted: ";

/// Replaces the course's README by a student's.
pub fn adapt(files: &mut Files) -> Result<()> {
    let mut missing = None;
    change(files, "README.md", |readme| {
        let mut text = String::new();
        for line in TEMPLATE.lines() {
            let heading = line
                .strip_prefix(QUOTED)
                .and_then(|rest| rest.strip_suffix(" -->"));
            match heading.map(|heading| (heading, section(readme, heading))) {
                Some((_, Some(section))) => text.push_str(section.trim_end()),
                Some((heading, None)) => missing = Some(heading),
                None => text.push_str(line),
            }
            text.push('\n');
        }
        text
    })?;
    match missing {
        None => Ok(()),
        Some(heading) => Err(Error::input(
            format!("README.md has no section `{heading}` for students"),
            "restore it, or mend tools/templates/handout/README.md, which quotes it",
        )),
    }
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
