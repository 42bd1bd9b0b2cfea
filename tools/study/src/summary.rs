//! The study's report: a page in Markdown, and lines for a terminal.

use std::fmt::Write;

use minijinja::syntax::SyntaxConfig;
use minijinja::value::{Serde, Value};
use minijinja::{Environment, context};
use serde::Serialize;

use crate::judge::{median_and_worst, rule_of_three};
use crate::result::Study;

/// The promises beside the measurements, for a terminal.
pub fn terminal(study: &Study) -> String {
    let mut text = String::new();
    let lengths = study.targets.iter().map(|t| t.about.chars().count());
    let width = lengths.max().unwrap_or(0);
    for target in &study.targets {
        let (mark, verdict) = match target.met {
            true => ("✓", "pass"),
            false => ("✗", "falls short"),
        };
        let (about, expected, measured) = (&target.about, &target.expected, &target.measured);
        let _ = writeln!(
            text,
            "{mark} {about:width$}  {expected:>24}  {measured}  {verdict}"
        );
    }
    let met = study.targets.iter().filter(|target| target.met).count();
    let _ = write!(text, "{met} of {} promises are kept", study.targets.len());
    text
}

/// The Markdown page, with the plots that were drawn. It shows a [`Study`], or the document
/// that one was written to.
pub fn summary(study: &impl Serialize, plots: &[String]) -> String {
    let mut page = Environment::new();
    // Lines with only a tag leave no blank line.
    let mut syntax = SyntaxConfig::builder();
    page.set_syntax(syntax.trim_blocks(true).build().expect("it is the default"));
    page.add_filter("share", share);
    page.add_filter("short", |number| or_dash(number, short));
    page.add_filter("scientific", |number| {
        or_dash(number, |number| format!("{number:.0e}"))
    });
    page.add_filter("fixed", |number, digits: usize| {
        or_dash(number, |number| format!("{number:.digits$}"))
    });
    page.add_filter("median_time_over", median_time_over);
    let text = page.render_str(
        include_str!("../templates/summary.md"),
        context! { plots => Serde(plots), ..Value::from(Serde(study)) },
    );
    text.expect("the template fits the study's fields")
        .trim_end()
        .to_owned()
        + "\n"
}

/// A share of wrong answers; if there are none, the upper bound that this proves.
fn share(wrong: u64, asked: u64) -> String {
    match (wrong, asked) {
        (_, 0) => "–".into(),
        (0, _) => format!("none (< {:.0e})", rule_of_three(asked)),
        _ if wrong * 10_000 < asked => format!("{wrong} of {asked}"),
        _ => format!("{:.2} %", 100.0 * wrong as f64 / asked as f64),
    }
}

/// A number, or a dash if it was not measured.
fn or_dash(number: Option<f64>, text: impl Fn(f64) -> String) -> String {
    number.map_or("–".into(), text)
}

/// A number with about two digits.
fn short(number: f64) -> String {
    match number {
        1000.0.. => format!("{number:.0e}"),
        10.0.. => format!("{number:.0}"),
        _ => format!("{number:.2}"),
    }
}

/// The median of the plans' times, each divided by another of its own times.
fn median_time_over(plans: Vec<Value>, other: &str) -> Option<f64> {
    let time = |plan: &Value, name| f64::try_from(plan.get_attr(name).ok()?).ok();
    let ratios = plans
        .iter()
        .filter_map(|plan| Some(time(plan, "nanoseconds")? / time(plan, other)?));
    median_and_worst(ratios)[0]
}

#[cfg(test)]
#[test]
fn the_committed_summary_shows_the_committed_study() {
    let read = |name| {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/record/");
        std::fs::read_to_string(format!("{folder}{name}")).expect("it is committed")
    };
    let study: serde_json::Value = serde_json::from_str(&read("study.json")).expect("JSON");
    let plots = [
        "sphere-distance.svg",
        "sphere-scale.svg",
        "triangle-edge-on.svg",
        "conditioning.svg",
        "mesh.svg",
    ];
    let page = summary(&study, &plots.map(String::from));
    assert_eq!(page, read("summary.md"));
}
