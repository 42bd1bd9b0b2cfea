//! What came of something, in a line or a few: of a task, a scene, a film, a belief.

use pinhole::judge::Verdict;

use pinhole_course::compile::Replaced;
use pinhole_course::diagnosis::{Diagnosis, Explanation, Reading};
use pinhole_course::escape::printable;
use pinhole_course::examination::{GroupResult, Outcome, SceneResult, TaskResult};
use pinhole_course::explanation::NoAnswer;
use pinhole_course::submission::Unusable;

/// A task in one line.
pub fn task_in_words(task: &TaskResult) -> String {
    let passes = |group: &&GroupResult| group.outcome.passes();
    let passing = task.groups.iter().filter(passes).count();
    match &task.replaced {
        Some(Replaced::Unusable(Unusable::Missing)) => "there is no such file".into(),
        Some(Replaced::Unusable(Unusable::Refused(why))) => format!("refused: {why}"),
        Some(Replaced::DoesNotCompile(_)) => "does not compile".into(),
        None if task.is_unanswered() => "unanswered".into(),
        None if passing == task.groups.len() => {
            let names: Vec<&str> = task
                .groups
                .iter()
                .map(|group| group.name.as_str())
                .collect();
            names.join(", ")
        }
        None => format!("{passing} of {} groups pass", task.groups.len()),
    }
}

/// A scene in one line.
pub fn scene_in_words(scene: &SceneResult) -> String {
    match &scene.outcome {
        Outcome::Judged(verdict) if verdict.passes() => {
            let exempt = match verdict.exempt {
                0 => String::new(),
                some => format!(", {some} exempt"),
            };
            format!(
                "{} pixels{exempt}, {:.2} s",
                verdict.resolution, scene.seconds
            )
        }
        other => outcome(other),
    }
}

/// An outcome in one line.
pub fn outcome(outcome: &Outcome) -> String {
    outcome_of(outcome, "pixels")
}

/// Why one question got no answer, in one line.
pub fn no_answer(why: &NoAnswer) -> String {
    match why {
        NoAnswer::NoRay => "there is no ray to ask about".into(),
        NoAnswer::NoFile(file) => format!("there is no usable {file}"),
        NoAnswer::DoesNotCompile(file) => format!("{file} does not compile"),
        NoAnswer::Failed(failure) => outcome(failure),
        NoAnswer::Nothing => "it gave no answer".into(),
    }
}

/// The same, of a film of these.
pub fn outcome_of(outcome: &Outcome, what: &str) -> String {
    match outcome {
        Outcome::Judged(verdict) => verdict_in_words(verdict, what),
        Outcome::Refused(refusal) => format!("refused: {refusal}"),
        Outcome::Unanswered => "unanswered".into(),
        Outcome::BlockedBy(task) => format!("blocked by `{task}`"),
        Outcome::Panicked(panic) => format!(
            "your code panicked at {}:{}: {}",
            printable(&panic.file),
            panic.line,
            printable(&panic.message)
        ),
        Outcome::TimedOut { seconds } => format!("gave no answer within {seconds:.0} s"),
        Outcome::OutOfMemory { most } => {
            format!("your program took more than {} MiB of memory", most >> 20)
        }
        Outcome::Died(how) => format!("your program did not finish: {}", printable(how)),
        Outcome::Garbled(why) => format!(
            "your program's answers could not be read: {}",
            printable(why)
        ),
    }
}

/// A verdict in one line, on a film of these.
pub fn verdict_in_words(verdict: &Verdict, what: &str) -> String {
    match verdict.failing.len() {
        0 => "passes".into(),
        wrong => format!(
            "{wrong} of {} {what} are wrong",
            verdict.resolution.pixels()
        ),
    }
}

/// A diagnosis in lines, without the hints.
pub fn diagnosis(diagnosis: &Diagnosis) -> String {
    let mut lines = Vec::new();
    if diagnosis.reading == Reading::OneOf {
        lines.push("One of these beliefs explains it, and this cannot tell them apart:".into());
    }
    for Explanation {
        mistake, explained, ..
    } in &diagnosis.beliefs
    {
        let belief = &mistake.belief;
        lines.push(match diagnosis.reading {
            Reading::OneOf => format!("- “{belief}”"),
            Reading::Together => format!(
                "You may believe: “{belief}” That explains {} of what is wrong here.",
                percent(*explained)
            ),
        });
    }
    lines.join("\n")
}

/// A share in words; “all” and “none” only if nothing is left to round.
pub fn percent(share: f64) -> String {
    match share {
        share if share >= 1.0 => "all".into(),
        share => format!("{:.0} %", (share * 100.0).clamp(1.0, 99.0)),
    }
}
