//! Finds images without an alternative text for readers who can't see them.

use super::pages::Pages;
use crate::error::Problem;

/// Images, drawings and canvases without an alternative text.
pub fn silent(pages: &Pages) -> Vec<Problem> {
    let mut problems = Vec::new();
    for (path, page) in pages {
        for (named, text) in &page.images {
            if text.as_ref().is_none_or(|text| text.trim().is_empty()) {
                let problem = format!("the image `{named}` has no alternative text");
                let remedy = "say in words what it shows";
                problems.push(Problem::of(path, problem, remedy));
            }
        }
    }
    problems
}

#[cfg(test)]
mod tests {
    use super::super::pages::Page;
    use super::*;

    #[test]
    fn images_and_drawings_need_an_alternative_text_unless_hidden() {
        let text = "<main><img src=a.png alt='A ray'><img src=b.png><img src=c.png alt=''>\
                    <svg></svg><svg aria-label='A ray'></svg><svg aria-hidden=true></svg></main>";
        let pages = Pages::from([("a.html".into(), Page::parse(text))]);
        let problems = silent(&pages);
        let told: Vec<&str> = problems
            .iter()
            .filter_map(|problem| problem.problem.split('`').nth(1))
            .collect();
        assert_eq!(told, ["b.png", "c.png", "svg"]);
    }
}
