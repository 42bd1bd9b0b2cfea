//! An examination as a table for people.
//!
//! The rows of `tasks` and `scenes` say what is wrong in each. `words` puts each kind of
//! thing into a line.

mod scenes;
mod tasks;
mod words;

use std::io::{IsTerminal, stdout};

use anstream::{AutoStream, ColorChoice};
use anstyle::{AnsiColor, Style};

use crate::escape::printable;
use pinhole::ask::MOST_PRINTED;
use pinhole_course::outcome::{Examination, TaskOutcome};
pub use scenes::{explain, note, remarks, worst_pixel};
pub use words::{
    diagnosis, earlier_in_words, facts, group_in_words, no_answer, outcome, outcome_of,
    scene_in_words, share, share_of_what, task_in_words, withheld_in_words,
};

pub const PASS: Style = AnsiColor::Green.on_default();
pub const FAIL: Style = AnsiColor::Red.on_default();
pub const QUIET: Style = AnsiColor::BrightBlack.on_default();
pub const STRONG: Style = Style::new().bold();

/// Text without its colours.
pub fn plain(text: &str) -> String {
    anstream::adapter::strip_str(text).to_string()
}

/// Whether standard output is a terminal that shows 24-bit colours.
pub fn shows_pictures() -> bool {
    let all = std::env::var("COLORTERM").is_ok_and(|it| it == "truecolor" || it == "24bit");
    all && stdout().is_terminal() && AutoStream::choice(&stdout()) != ColorChoice::Never
}

/// How many lines of a student's output are shown.
const MOST_PRINTED_LINES: usize = 20;

/// The whole table: tasks, scenes, what went wrong, and the sum of points.
pub fn examination(examination: &Examination) -> String {
    let mut text = String::new();
    let outcome = &examination.outcome;
    let submission = printable(&outcome.submission);
    line(
        &mut text,
        format!(
            "{STRONG}{}{STRONG:#}  {QUIET}{submission}{QUIET:#}",
            outcome.assignment
        ),
    );
    let tasks = outcome.tasks.iter().map(|task| &task.name);
    let names = tasks.chain(outcome.scenes.iter().map(|scene| &scene.name));
    let width = names.map(String::len).max().unwrap_or(0).max(5) + 2;
    if !outcome.tasks.is_empty() {
        line(&mut text, heading("task", width));
    }
    for task in &outcome.tasks {
        tasks::rows(&mut text, task, width, tasks::Extent::All);
    }
    scenes::rows(&mut text, examination, width);
    if let Some(earlier) = &outcome.earlier {
        line(&mut text, format!("  {}", earlier_in_words(earlier)));
    }
    let (earned, possible) = (outcome.points.unwrap_or_default(), outcome.possible);
    line(
        &mut text,
        format!(
            "\n{STRONG}  {:<width$}{earned:>3} / {possible}{STRONG:#}",
            "total"
        ),
    );
    if let Some(words) = withheld_in_words(outcome) {
        line(&mut text, format!("  {QUIET}{words}{QUIET:#}"));
    }
    text.push_str(&printed(&outcome.printed));
    text
}

/// One task with its first failing group. `width` is that of its name.
pub fn task(task: &TaskOutcome, width: usize) -> String {
    let mut text = String::new();
    tasks::rows(&mut text, task, width, tasks::Extent::First);
    text
}

/// The scenes.
pub fn scenes(examination: &Examination) -> String {
    let mut text = String::new();
    let names = examination.outcome.scenes.iter();
    let names = names.map(|scene| scene.name.len());
    scenes::rows(&mut text, examination, names.max().unwrap_or(0) + 2);
    text
}

/// The beginning of what a student's code printed. Empty if it printed nothing.
pub fn printed(printed: &str) -> String {
    let mut text = String::new();
    let lines: Vec<&str> = printed.lines().collect();
    if !lines.is_empty() {
        line(&mut text, "\nyour code printed:".into());
        for printed in lines.iter().take(MOST_PRINTED_LINES) {
            line(
                &mut text,
                format!("  {QUIET}{}{QUIET:#}", printable(printed)),
            );
        }
        if lines.len() > MOST_PRINTED_LINES {
            line(
                &mut text,
                format!("  … and {} more lines", lines.len() - MOST_PRINTED_LINES),
            );
        }
        if let Some(remark) = on_much_output(printed) {
            line(&mut text, format!("  {remark}"));
        }
    }
    text
}

/// What to say of code that prints so much that it may be too slow to be graded.
pub fn on_much_output(printed: &str) -> Option<&'static str> {
    let remark = "Printing so much takes time, and code is stopped after a few seconds when it is graded. \
                  Remove this before you hand in.";
    (printed.len() >= MOST_PRINTED).then_some(remark)
}

fn line(text: &mut String, line: String) {
    text.push_str(&line);
    text.push('\n');
}

fn heading(what: &str, width: usize) -> String {
    format!("\n{QUIET}  {what:<width$}points{QUIET:#}")
}

/// One line of the table. `width` is that of the column of names.
fn row(text: &mut String, name: &str, width: usize, points: (u32, u32), said: String) {
    let (earned, possible) = points;
    let full = earned == possible;
    let (style, mark) = if full { (PASS, "✓") } else { (FAIL, "✗") };
    line(
        text,
        format!("{style}{mark}{style:#} {name:<width$}{earned:>3} / {possible:<4} {said}"),
    );
}

fn indent(text: &mut String, block: &str) {
    for row in block.lines() {
        line(text, format!("      {row}"));
    }
}
