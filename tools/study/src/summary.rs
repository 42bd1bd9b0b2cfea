//! Texts for people: the study's page in Markdown, its promises, and the description of a plan.

use minijinja::syntax::SyntaxConfig;
use minijinja::value::{Serde, Value};
use minijinja::{Environment, context};
use serde::Serialize;

use crate::judge::{median_and_worst, rule_of_three};
use crate::plan::Plan;
use crate::result::Study;

/// The promises beside the measurements, for a terminal.
pub fn terminal(study: &Study) -> String {
    filled(include_str!("../templates/promises.txt"), Serde(study))
}

/// Describes a plan for the named scene, for a terminal.
pub fn description(plan: &Plan, scene: &str) -> String {
    let values = context! { scene, ..Value::from(Serde(plan)) };
    filled(include_str!("../templates/plan.txt"), values)
}

/// The Markdown page, with the plots that were drawn. It shows a [`Study`], or the document
/// that one was written to.
pub fn summary(study: &impl Serialize, plots: &[String]) -> String {
    let values = context! { plots => Serde(plots), ..Value::from(Serde(study)) };
    filled(include_str!("../templates/summary.md"), values)
}

/// A template with these values, and one line end after its last line.
fn filled(template: &str, values: impl Into<Value>) -> String {
    let mut page = Environment::new();
    // Lines with only a tag leave no blank line.
    let mut syntax = SyntaxConfig::builder();
    page.set_syntax(syntax.trim_blocks(true).build().expect("it is the default"));
    page.add_filter("left", |text: String, width: usize| {
        format!("{text:width$}")
    });
    page.add_filter("right", |text: String, width: usize| {
        format!("{text:>width$}")
    });
    page.add_filter("share", share);
    page.add_filter("short", |number| or_dash(number, short));
    page.add_filter("exponential", |number: f64| format!("{number:e}"));
    page.add_filter("bound", |number| or_dash(number, bound));
    page.add_filter("fixed", |number, digits: usize| {
        or_dash(number, |number| format!("{number:.digits$}"))
    });
    page.add_filter("median_time_over", median_time_over);
    let text = page.render_str(template, values.into());
    let text = text.expect("the template fits the fields");
    text.trim_end().to_owned() + "\n"
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

/// A bound with one digit, rounded up, so that the text promises no more than the number.
fn bound(number: f64) -> String {
    let nearest = format!("{number:.0e}");
    match nearest.parse::<f64>() {
        Ok(less) if less < number => {
            let step = 10f64.powi(less.log10().floor() as i32);
            format!("{:.0e}", number + 0.6 * step)
        }
        _ => nearest,
    }
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
fn bounds_are_rounded_up() {
    for (number, text) in [
        (2e-8, "2e-8"),
        (2.1e-8, "3e-8"),
        (2.6e-8, "3e-8"),
        (9.2e-8, "1e-7"),
        (1e-12, "1e-12"),
        (0.0, "0e0"),
        (3.0000001, "4e0"),
    ] {
        assert_eq!(bound(number), text);
    }
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
