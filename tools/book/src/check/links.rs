//! Finds links to pages, files and anchors that are not there.

use std::path::{Component, Path, PathBuf};

use super::pages::{Page, Pages};
use crate::edition::Edition;
use crate::error::Problem;

/// Links that lead nowhere. Links out of the book are not followed, because the check must work
/// without a network, as the book does.
pub fn dead(pages: &Pages, folder: &Path, edition: Edition) -> Vec<Problem> {
    let mut problems = Vec::new();
    for (path, page) in pages {
        for link in page.links.iter().filter(|link| is_inside(link)) {
            if let Some(what) = wrong(link, path, page, pages, folder) {
                let file = PathBuf::from(edition.name()).join(path);
                let remedy = "correct the link, or the heading that it names";
                let problem = Problem::of(file, format!("`{link}`: {what}"), remedy);
                if !problems.contains(&problem) {
                    problems.push(problem);
                }
            }
        }
    }
    problems
}

/// Words after a link by which the text promises something about the linked page.
const PROMISES: [&str; 6] = ["says", "shows", "measures", "counts", "explains", "warns"];

/// Links to a whole page, where the text promises that the page shows something. Readers would have
/// to search the page for it.
pub fn vague(pages: &Pages, edition: Edition) -> Vec<Problem> {
    let mut problems = Vec::new();
    for (path, page) in pages {
        let promises = page.followed.iter().filter(|(link, word)| {
            is_inside(link) && !link.contains('#') && PROMISES.contains(&word.as_str())
        });
        for (link, word) in promises {
            let file = PathBuf::from(edition.name()).join(path);
            let problem = format!(
                "the text says that `{link}` {word} something, but the link names no section"
            );
            let remedy = "add the section to the link";
            problems.push(Problem::of(file, problem, remedy));
        }
    }
    problems
}

fn is_inside(link: &str) -> bool {
    let outside = ["http://", "https://", "mailto:", "data:", "javascript:"];
    !outside.iter().any(|start| link.starts_with(start))
}

fn wrong(link: &str, path: &Path, page: &Page, pages: &Pages, folder: &Path) -> Option<String> {
    let (file, anchor) = link.split_once('#').unwrap_or((link, ""));
    let file = file.split('?').next().unwrap_or(file);
    let target = match file {
        "" => path.to_owned(),
        file => resolved(path.parent()?, file),
    };
    let target_page = match file {
        "" => Some(page),
        _ => pages.get(&target),
    };
    if target_page.is_none() && !folder.join(&target).is_file() {
        return Some("there is no such page or file".into());
    }
    match target_page {
        Some(page) if !anchor.is_empty() && !page.ids.iter().any(|id| id == anchor) => {
            Some(format!("the page has no anchor `{anchor}`"))
        }
        _ => None,
    }
}

fn resolved(folder: &Path, file: &str) -> PathBuf {
    let mut path = folder.to_owned();
    for component in Path::new(file).components() {
        match component {
            Component::ParentDir => {
                path.pop();
            }
            Component::Normal(name) => path.push(name),
            _ => {}
        }
    }
    path
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dead_pages_and_dead_anchors_are_found_and_good_ones_are_not() {
        let folder = tempfile::tempdir().unwrap();
        let page = |text: &str| Page::parse(text);
        let pages = Pages::from([
            (
                "a.html".into(),
                page("<h2 id=here></h2><a href='#here'></a><a href='#gone'></a>"),
            ),
            (
                "in/b.html".into(),
                page(
                    "<a href='../a.html#here'></a><a href='../a.html#no'></a><a href='c.html'></a>\
                      <a href='https://elsewhere'></a><img src='x.png'>",
                ),
            ),
        ]);
        let problems = dead(&pages, folder.path(), Edition::Student);
        let told: Vec<&str> = problems
            .iter()
            .map(|problem| problem.problem.as_str())
            .collect();
        let expected = [
            "`#gone`: the page has no anchor `gone`",
            "`../a.html#no`: the page has no anchor `no`",
            "`c.html`: there is no such page or file",
            "`x.png`: there is no such page or file",
        ];
        assert_eq!(told, expected);
    }
}
