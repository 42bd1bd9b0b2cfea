//! Finds words that are neither in the English dictionary nor in the book's own list,
//! `book/words.txt`.

use std::path::Path;

use pinhole_course::checkout::Checkout;

use crate::error::{Problem, Result};
use crate::interactive;

/// Unknown words and their places.
pub fn check(checkout: &Checkout) -> Result<Vec<Problem>> {
    Ok(
        match interactive::npm(&["run", "--silent", "spell"], checkout)? {
            Ok(_) => Vec::new(),
            Err(said) => {
                let told: Vec<Problem> = said.lines().filter_map(problem).collect();
                match told.is_empty() {
                    true => vec![Problem::of(
                        "book/interactive/cspell.json",
                        said,
                        "correct it",
                    )],
                    false => told,
                }
            }
        },
    )
}

/// Parses a line of cspell, `FILE:LINE:COLUMN - Unknown word (WORD) Suggestions: [...]`, with the
/// file's path relative to `book`. A test in `book/interactive/test` checks that cspell finds
/// one.
fn problem(line: &str) -> Option<Problem> {
    let (place, told) = line.split_once(" - ")?;
    let mut place = place.rsplitn(3, ':').skip(1);
    let number = place.next()?.trim().parse().ok()?;
    let file = Path::new("book").join(place.next()?.trim());
    let word = told.split_once('(')?.1.split_once(')')?.0;
    let remedy = "correct the word, or add it to book/words.txt if it is spelt right";
    Some(Problem::at(
        file,
        number,
        format!("`{word}` is not a known word"),
        remedy,
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn unknown_word_is_reported_with_its_line() {
        let line = "src/rays.md:7:12 - Unknown word (parametre) Suggestions: [parameter]";
        let problem = problem(line).unwrap();
        assert_eq!(
            (problem.file.to_str(), problem.line),
            (Some("book/src/rays.md"), Some(7))
        );
        assert!(problem.problem.contains("`parametre`"), "{problem}");
    }
}
