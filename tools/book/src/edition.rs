//! The two editions, and which lines of a page each shows.

use std::path::Path;

use crate::error::Problem;

/// An edition of the book, by its readers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum Edition {
    /// For students, without solutions.
    Student,
    /// For instructors, with everything.
    Instructor,
}

/// Opens a part for instructors, alone on its line.
const OPEN: &str = "{{#instructor}}";

/// Closes such a part.
const CLOSE: &str = "{{/instructor}}";

impl Edition {
    /// Both editions.
    pub const ALL: [Edition; 2] = [Edition::Student, Edition::Instructor];

    /// The name of its folder.
    pub fn name(self) -> &'static str {
        match self {
            Edition::Student => "student",
            Edition::Instructor => "instructor",
        }
    }

    /// Whether a chapter is in this edition. `path` is the one in `SUMMARY.md`.
    pub fn has(self, path: &Path) -> bool {
        self == Edition::Instructor || !path.starts_with("instructor")
    }

    /// A page without the markers and, in the students' edition, without the parts that they
    /// enclose. Removed lines become empty ones, so that all others keep their numbers.
    pub fn lines(self, page: &str, file: &Path) -> Result<String, Problem> {
        let mut opened: Option<usize> = None;
        let mut kept = String::new();
        for (line, text) in (1..).zip(page.lines()) {
            match text.trim() {
                OPEN if opened.is_some() => {
                    let remedy = format!("close the first with {CLOSE}");
                    return Err(Problem::at(
                        file,
                        line,
                        "an instructor's part inside another one",
                        remedy,
                    ));
                }
                OPEN => opened = Some(line),
                CLOSE if opened.is_none() => {
                    let remedy = format!("put {OPEN} where it begins, or remove this line");
                    return Err(Problem::at(
                        file,
                        line,
                        format!("{CLOSE} closes nothing"),
                        remedy,
                    ));
                }
                CLOSE => opened = None,
                other if other.contains(OPEN) || other.contains(CLOSE) => {
                    let remedy = "put it on a line of its own";
                    return Err(Problem::at(
                        file,
                        line,
                        "a marker beside other text",
                        remedy,
                    ));
                }
                _ if opened.is_none() || self == Edition::Instructor => kept.push_str(text),
                _ => {}
            }
            kept.push('\n');
        }
        match opened {
            Some(line) => Err(Problem::at(
                file,
                line,
                "an instructor's part without an end",
                format!("put {CLOSE} where it ends"),
            )),
            None => Ok(kept),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const PAGE: &str = "one\n{{#instructor}}\nsecret\n{{/instructor}}\ntwo\n";

    fn lines(edition: Edition, page: &str) -> Result<String, Problem> {
        edition.lines(page, Path::new("page.md"))
    }

    #[test]
    fn students_do_not_see_the_instructors_part_and_lines_keep_their_numbers() {
        assert_eq!(lines(Edition::Student, PAGE).unwrap(), "one\n\n\n\ntwo\n");
        assert_eq!(
            lines(Edition::Instructor, PAGE).unwrap(),
            "one\n\nsecret\n\ntwo\n"
        );
    }

    #[test]
    fn a_part_without_an_end_is_an_error_at_its_first_line() {
        let problem = lines(Edition::Student, "a\n{{#instructor}}\nb\n").unwrap_err();
        assert_eq!(problem.line, Some(2));
        assert!(problem.problem.contains("without an end"), "{problem}");
    }

    #[test]
    fn a_marker_without_its_partner_or_beside_text_is_an_error() {
        for page in [
            "{{/instructor}}\n",
            "{{#instructor}}\n{{#instructor}}\n",
            "see {{#instructor}}\n",
        ] {
            assert!(lines(Edition::Student, page).is_err(), "{page}");
        }
    }
}
