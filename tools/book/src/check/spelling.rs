//! Words that neither English nor the book's own list, `book/words.txt`, knows.

use std::path::Path;

use crate::checkout::Checkout;
use crate::error::{Problem, Result};
use crate::interactive;

/// Unknown words, each in its place.
pub fn check(checkout: &Checkout) -> Result<Vec<Problem>> {
    let pages = checkout.book().join("src/**/*.md").display().to_string();
    let arguments = ["run", "--silent", "spell", "--", &pages];
    Ok(match interactive::npm(&arguments, &[], checkout)? {
        Ok(_) => Vec::new(),
        Err(said) => {
            let told: Vec<Problem> = said
                .lines()
                .filter_map(|line| problem(line, checkout))
                .collect();
            match told.is_empty() {
                true => vec![Problem::of("book/interactive/cspell.json", said, "mend it")],
                false => told,
            }
        }
    })
}

/// A line of cspell: `FILE:LINE:COLUMN - Unknown word (WORD) Suggestions: [...]`.
fn problem(line: &str, checkout: &Checkout) -> Option<Problem> {
    let (place, told) = line.split_once(" - ")?;
    let mut place = place.rsplitn(3, ':').skip(1);
    let number = place.next()?.trim().parse().ok()?;
    let file = checkout.inside(Path::new(place.next()?.trim()));
    let word = told.split_once('(')?.1.split_once(')')?.0;
    let remedy = "correct it, or add it to book/words.txt if it is right";
    Some(Problem::at(
        file,
        number,
        format!("`{word}` is no word we know"),
        remedy,
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_unknown_word_is_told_with_its_line() {
        let checkout = Checkout::at(Path::new("/checkout"));
        let line =
            "/checkout/book/src/rays.md:7:12 - Unknown word (parametre) Suggestions: [parameter]";
        let problem = problem(line, &checkout).unwrap();
        assert_eq!(
            (problem.file.to_str(), problem.line),
            (Some("book/src/rays.md"), Some(7))
        );
        assert!(problem.problem.contains("`parametre`"), "{problem}");
    }
}
