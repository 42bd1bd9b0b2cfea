//! Recognises answers by their files' names, even if people or programs have changed them.

use pinhole_course::assignment::{Assignment, Task, examples_file};

/// The longest name of a file, because no common file system allows longer ones.
const MOST_BYTES: usize = 255;

/// The answer file, or the file of examples, that a file of this name may be, and whether its name
/// is exactly that. Recognises names that people or programs have changed: `Sphere.rs`, `sphere
/// (1).rs`, `sphere 2.rs`, `sphere.rs.txt`, `Kopie von sphere.rs`.
pub fn file_of(name: &str, assignment: &Assignment) -> Option<(String, bool)> {
    // In an archive, a name may be long, and is then compared in hundreds of ways.
    if name.len() > MOST_BYTES {
        return None;
    }
    let answers = assignment.answerable().map(Task::file);
    let examples = assignment.with_examples();
    let examples = examples.map(|task| examples_file(&task.name));
    let files: Vec<String> = answers.chain(examples).collect();
    if files.iter().any(|file| file == name) {
        return Some((name.into(), true));
    }
    let normalized = normalized(name)?;
    let is_meant = |file: &String| joined(file) == normalized;
    Some((files.into_iter().find(is_meant)?, false))
}

/// Whether a file's name contains a task's name.
pub fn is_similar(name: &str, task: &Task) -> bool {
    joined(name).contains(&joined(&task.name))
}

/// A name in lower case, without marks between its words.
fn joined(name: &str) -> String {
    name.to_lowercase().replace([' ', '-', '_'], "")
}

/// A file's name in lower case, without marks between its words and marks of a copy. `None` if it
/// has no extension.
fn normalized(name: &str) -> Option<String> {
    let lower = name.trim().to_lowercase();
    let lower = lower.strip_suffix(".txt").unwrap_or(&lower);
    let (stem, end) = lower.rsplit_once('.')?;
    let mut stem = stem.trim();
    let before = COPY
        .iter()
        .find_map(|(before, _)| stem.strip_prefix(before));
    stem = before.unwrap_or(stem);
    loop {
        let shorter = without_count(stem);
        let copy = COPY
            .iter()
            .find_map(|(_, after)| shorter.strip_suffix(after));
        let shorter = copy.unwrap_or(shorter);
        let shorter = shorter.trim_end_matches([' ', '-', '_']);
        if shorter == stem {
            break;
        }
        stem = shorter;
    }
    Some(format!("{}.{end}", joined(stem)))
}

/// What systems put before and after the names of copies.
const COPY: [(&str, &str); 4] = [
    ("copy of ", "copy"),
    ("kopie von ", "kopie"),
    ("copie de ", "copie"),
    ("copia de ", "copia"),
];

/// A name without `(2)`, `-2` or ` 2` at its end.
fn without_count(stem: &str) -> &str {
    let is_count = |text: &str| !text.is_empty() && text.chars().all(|c| c.is_ascii_digit());
    let in_brackets = stem
        .strip_suffix(')')
        .and_then(|stem| stem.rsplit_once('('));
    match in_brackets.or(stem.rsplit_once(['-', ' '])) {
        Some((shorter, count)) if is_count(count) => shorter,
        _ => stem,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_that_programs_and_people_change_still_name_their_task() {
        for name in [
            "Triangle_Soup.rs",
            "triangle_soup.RS",
            "triangle_soup (1).rs",
            "triangle_soup(12).rs",
            "triangle_soup-1.rs",
            "triangle_soup - Copy.rs",
            "triangle_soup - Copy (2).rs",
            "Copy of triangle_soup.rs",
            "triangle soup copy.rs",
            "triangle_soup copy 2.rs",
            "triangle_soup_copy.rs",
            "triangle_soup-kopie.rs",
            "triangle_soup 2.rs",
            "Kopie von triangle_soup.rs",
            "triangle_soup - Kopie.rs",
            "TriangleSoup.rs",
            "triangle_soup.rs.txt",
        ] {
            assert_eq!(
                normalized(name).as_deref(),
                Some("trianglesoup.rs"),
                "{name}"
            );
        }
        for name in [
            "triangle_soup.rs~",
            "triangle_soup2.rs",
            "soup.rs",
            "triangle_soup.c",
        ] {
            assert_ne!(
                normalized(name).as_deref(),
                Some("trianglesoup.rs"),
                "{name}"
            );
        }
        let examples = normalized("Copy of Soup.examples (1).toml");
        assert_eq!(examples.as_deref(), Some("soup.examples.toml"));
    }
}
