//! Points for the examples that a student hands in.

use std::path::Path;

use pinhole::Fact;

use super::{JudgedExamples, Verdict, judge};
use crate::assignment::{Assignment, examples_file};
use crate::checkout::Checkout;
use crate::error::{Fault, Result};
use crate::outcome::{FilmOutcome, GroupOutcome, Outcome};
use crate::submission::{AnswerFileProblem, Submission};

/// The most bytes of a message, which may quote the student's file.
const MOST_BYTES: usize = 1000;

/// Judges the examples in a submission. Each task that gives points for examples gets a group for
/// them.
///
/// # Errors
/// If examples can't be judged through no fault of the student's. But if someone waits for the
/// result (`interactive`), the group says so instead, and earns nothing.
pub fn add_handed_in(
    outcome: &mut Outcome,
    submission: &Submission,
    assignment: &Assignment,
    checkout: &Checkout,
    interactive: bool,
) -> Result<()> {
    for got in &mut outcome.tasks {
        let Some(task) = assignment.task(&got.name) else {
            continue;
        };
        let (Some(examples), Some(points)) = (&task.examples, task.all_points().last()) else {
            continue;
        };
        let file = examples_file(&task.name);
        let judge = |text: &str| judge((Path::new(&file), text), assignment, checkout, interactive);
        let not_judged = |why: String| (false, why, Vec::new());
        let (passes, says, shown) = match submission.text(&file) {
            Some(Ok(text)) => match judge(text) {
                Ok(judged) if judged.task == task.name => verdict(judged, examples.get_ref().catch),
                Ok(judged) => not_judged(format!("{file} is about `{}`", judged.task)),
                Err(error) if error.fault == Fault::Environment && !interactive => {
                    return Err(error);
                }
                Err(error) => not_judged(shortened(&error.problem)),
            },
            Some(Err(AnswerFileProblem::Refused(why))) => {
                not_judged(format!("{file} is refused: {why}"))
            }
            _ => not_judged(format!("there is no {file} beside {}", task.file())),
        };
        let film = FilmOutcome::Examples { passes, says };
        let (name, about) = (points.group, points.about);
        let group = GroupOutcome::new(name, about, points.worth, film, shown);
        got.groups.push(group);
    }
    outcome.add_up();
    Ok(())
}

/// Whether examples earn their points, why or why not, and the first wrong one.
fn verdict(judged: JudgedExamples, catch: f64) -> (bool, String, Vec<Fact>) {
    let (right, wrong) = (judged.count(Verdict::Right), judged.count(Verdict::Wrong));
    let (caught, all) = (judged.caught, judged.mistakes);
    // A product such as 0.7 × 10 may miss a whole number by a rounding error.
    let needed = (catch * all as f64 - 1e-9).ceil() as usize;
    let says = match (wrong, right) {
        (0, 0) => "no example has an answer yet".into(),
        (0, _) => format!("they catch {caught} of {all} mistakes, and must catch {needed}"),
        (1, _) => "1 example is wrong".into(),
        _ => format!("{wrong} examples are wrong"),
    };
    let mut examples = judged.examples.into_iter();
    let first = examples.find(|example| example.verdict == Verdict::Wrong);
    let shown = first.map(|it| {
        let name = Fact::new("example", format!("{} {}", it.group, it.question));
        let wrong = Fact::new("wrong", it.wrong.join(", "));
        [vec![name], it.asked, vec![wrong]].concat()
    });
    let passes = wrong == 0 && right > 0 && caught >= needed;
    (passes, says, shown.unwrap_or_default())
}

/// The first line and the last line of a message. What is between may be a trace with paths.
fn shortened(message: &str) -> String {
    let cut = |line: &str| line[..line.floor_char_boundary(MOST_BYTES / 2)].to_owned();
    let (first, rest) = message.split_once('\n').unwrap_or((message, ""));
    let last = rest.lines().last().unwrap_or_default();
    format!("{} {}", cut(first), cut(last)).trim_end().into()
}
