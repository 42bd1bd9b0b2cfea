//! Adds a course's final mark to a report that is already written.

use minijinja::{context, value::Serde};
use serde::Serialize;

use super::environment;

/// A mark goes between these two comments. Students' text can't contain them, because it is
/// escaped.
const OPEN: &str = "<!-- mark -->";
const CLOSE: &str = "<!-- /mark -->";

/// A mark, in words.
#[derive(Debug, PartialEq, Serialize)]
pub struct FinalMark {
    /// The mark that goes into the gradebook.
    pub points: String,
    /// The possible points.
    pub possible: String,
    /// The points that the answers earned.
    pub judged: String,
    /// Why the mark differs from the points.
    pub why: Vec<String>,
}

/// The report with this mark, or without one. `None` if the page has no place for a mark.
pub fn with_mark(page: &str, mark: Option<&FinalMark>) -> Option<String> {
    let (before, rest) = page.split_once(OPEN)?;
    let (_, after) = rest.split_once(CLOSE)?;
    let words = mark.map_or(String::new(), in_words);
    Some(format!("{before}{OPEN}{words}{CLOSE}{after}"))
}

fn in_words(mark: &FinalMark) -> String {
    let environment = environment(&[("mark.html", include_str!("../../templates/mark.html"))]);
    let text = environment.get_template("mark.html");
    let text = text.and_then(|template| template.render(context! { mark => Serde(mark) }));
    text.unwrap_or_else(|error| panic!("mark.html's template: {error:#}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_report_has_one_mark_and_its_reasons_are_escaped() {
        let page = format!("<p>before</p>{OPEN}{CLOSE}<p>after</p>");
        let mark = |points: &str| FinalMark {
            points: points.into(),
            possible: "100".into(),
            judged: "90".into(),
            why: vec!["−10: <b>late</b>".into()],
        };
        let once = with_mark(&page, Some(&mark("80"))).expect("there is room");
        assert!(
            once.contains("Your mark: 80 of 100") && once.contains("&lt;b&gt;late"),
            "{once}"
        );
        let again = with_mark(&once, Some(&mark("81"))).expect("there is room");
        assert!(
            again.contains("81 of") && !again.contains("80 of"),
            "{again}"
        );
        assert_eq!(with_mark(&again, None), Some(page));
        assert_eq!(with_mark("<p>old</p>", Some(&mark("80"))), None);
    }
}
