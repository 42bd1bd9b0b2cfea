//! Finds directives that were not expanded because they are inside code. Readers would see them.

use super::pages::Pages;
use crate::error::Problem;

/// Directives that were not expanded.
pub fn stray_directives(pages: &Pages) -> Vec<Problem> {
    let mut problems = Vec::new();
    for (path, page) in pages {
        for directive in &page.directives {
            let problem =
                format!("the directive `{directive}` is inside code, where nothing is inserted");
            let remedy = "write it outside of the backticks";
            problems.push(Problem::of(path, problem, remedy));
        }
    }
    problems
}
