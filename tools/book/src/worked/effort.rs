//! How much work a task is for a student: how many words there are to read, and how many lines to
//! write.

use pinhole_course::checkout::Checkout;

use super::Values;
use crate::course::assignments;
use crate::error::Result;

/// Words that people read in a minute, if the text is easy.
const WORDS_A_MINUTE: usize = 200;

/// Parts of a page that need not be read: each begins and ends at a line that contains these.
const OPTIONAL: [[&str; 2]; 2] = [
    ["<details>", "</details>"],
    ["{{#instructor}}", "{{/instructor}}"],
];

/// Adds each task's minutes of reading and its lines of code.
pub fn add(values: &mut Values, checkout: &Checkout) -> Result<()> {
    for assignment in assignments(checkout)? {
        for task in &assignment.tasks {
            let page = task.chapter.to_lowercase().replace(' ', "_");
            let page = checkout.read(format!("book/src/{page}.md"))?;
            let minutes = words(&page).div_ceil(WORDS_A_MINUTE);
            let answer = assignment.reference().join("src").join(task.file());
            let lines = lines(&checkout.read(answer)?);
            values.insert(format!("read_{}", task.name), minutes.to_string());
            values.insert(format!("write_{}", task.name), lines.to_string());
        }
    }
    Ok(())
}

/// The words of a page without its optional parts, directives, tables and headings.
fn words(page: &str) -> usize {
    let mut skipping_to = None;
    let mut count = 0;
    for line in page.lines() {
        let opened = OPTIONAL.iter().find(|[open, _]| line.contains(open));
        if let Some([_, close]) = opened {
            skipping_to = Some(close);
        } else if skipping_to.is_none() && !line.starts_with(['{', '|', '#']) {
            count += line.split_whitespace().count();
        }
        skipping_to = skipping_to.filter(|close| !line.contains(**close));
    }
    count
}

/// The lines of an answer that are neither empty nor comments.
fn lines(source: &str) -> usize {
    let parts = source.split("// ANCHOR: answer\n").skip(1);
    let answers = parts.filter_map(|part| part.split("// ANCHOR_END: answer").next());
    let lines = answers.flat_map(str::lines).map(str::trim);
    lines
        .filter(|line| !line.is_empty() && !line.starts_with("//"))
        .count()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn folded_parts_and_comments_are_not_counted() {
        let page = "# A title\n\nThree plain words.\n\n<details><summary>More?</summary>\n\n\
                    Much more.\n\n</details>\n| a | b |\nTwo more.\n";
        assert_eq!(words(page), 5);
        let source = "fn f() {\n    // ANCHOR: answer\n    let x = 1;\n\n    // So.\n    x\n    \
                      // ANCHOR_END: answer\n}\n";
        assert_eq!(lines(source), 2);
    }
}
