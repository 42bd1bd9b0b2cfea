//! How hard each chapter is to read.

use std::path::Path;

use pinhole_reading::grade;

use super::pages::Pages;
use crate::error::Problem;

/// The highest grade that a chapter may have.
const HARDEST: f64 = 10.0;

/// Pages with fewer words are left out, because the grade of a short text is mostly chance.
const FEWEST_WORDS: usize = 100;

/// Every page with a title and enough words, and its grade.
fn graded(pages: &Pages) -> impl Iterator<Item = (&Path, &str, f64)> {
    pages.iter().filter_map(|(path, page)| {
        let title = page.headings.first()?;
        let words = page.prose.iter().flat_map(|prose| prose.split_whitespace());
        if words.count() < FEWEST_WORDS {
            return None;
        }
        Some((path.as_path(), title.as_str(), grade(&page.prose)?))
    })
}

/// Pages that are too hard to read.
pub fn hard(pages: &Pages) -> Vec<Problem> {
    let hard = graded(pages).filter(|(_, _, grade)| *grade > HARDEST);
    let problem = |(path, _, grade): (&Path, &str, f64)| {
        let problem = format!("its reading grade is {grade:.1}, above {HARDEST}");
        Problem::of(path, problem, "write shorter sentences and shorter words")
    };
    hard.map(problem).collect()
}

/// The chapters and their grades for the console, the hardest first.
pub fn grades(pages: &Pages) -> String {
    let mut grades: Vec<(f64, &str)> = graded(pages)
        .map(|(_, title, grade)| (grade, title))
        .collect();
    // The first page is also `index.html`.
    grades.sort_by(|one, other| other.0.total_cmp(&one.0).then(one.1.cmp(other.1)));
    grades.dedup();
    let lines = grades
        .iter()
        .map(|(grade, title)| format!("{grade:6.1}  {title}\n"));
    format!(
        "reading grade, hardest first:\n{}",
        lines.collect::<String>()
    )
}

#[cfg(test)]
mod tests {
    use super::super::pages::Page;
    use super::*;

    #[test]
    fn a_hard_page_is_reported_unless_it_is_short() {
        let hard = "Numerically unstable discriminants invalidate intersections whenever cancellation \
                    eliminates significant digits of intermediate quantities.";
        let page = |text: &str| Page::parse(&format!("<main><h1>Rays</h1><p>{text}</p></main>"));
        let pages = Pages::from([
            ("a.html".into(), page(&"The ray hits the ball. ".repeat(20))),
            ("b.html".into(), page(&hard.repeat(10))),
            ("c.html".into(), page(hard)),
        ]);
        let reported: Vec<_> = super::hard(&pages).into_iter().map(|it| it.file).collect();
        assert_eq!(reported, [Path::new("b.html")]);
    }
}
