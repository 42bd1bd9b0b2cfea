//! Directives that a reader would see: in code nothing is put in, for code is left alone.

use super::pages::Pages;
use crate::error::Problem;

/// Directives that stand in a page as they were written.
pub fn left_over(pages: &Pages) -> Vec<Problem> {
    let mut problems = Vec::new();
    for (path, page) in pages {
        for directive in &page.directives {
            let problem = format!("the directive `{directive}` stands in code, and is not put in");
            let remedy = "write it outside of the backticks";
            problems.push(Problem::of(path, problem, remedy));
        }
    }
    problems
}
