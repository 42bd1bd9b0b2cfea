//! Puts a belief, or the outcome of a task, a scene or a film, into one or a few lines.

use crate::escape::printable;
use pinhole::Fact;
use pinhole_course::diagnosis::{Diagnosis, Explanation, Reading};
use pinhole_course::explanation::NoAnswer;
use pinhole_course::outcome::{
    AnswerFile, Comparison, EarlierOutcome, FilmOutcome, GroupOutcome, Outcome, SceneOutcome,
    Status, TaskOutcome,
};

/// A task in one line.
pub fn task_in_words(task: &TaskOutcome) -> String {
    let passes = |group: &&GroupOutcome| group.outcome.passes();
    let passing = task.groups.iter().filter(passes).count();
    match &task.file {
        AnswerFile::Missing => format!("the file {}.rs is missing", task.name),
        AnswerFile::Refused { why } => format!("refused: {why}"),
        AnswerFile::DoesNotCompile { .. } => "does not compile".into(),
        AnswerFile::Compiled if task.is_unanswered() => "unanswered".into(),
        AnswerFile::Compiled if passing == task.groups.len() => {
            let names: Vec<&str> = task
                .groups
                .iter()
                .map(|group| group.name.as_str())
                .collect();
            names.join(", ")
        }
        AnswerFile::Compiled => format!("{passing} of {} groups pass", task.groups.len()),
    }
}

/// Says that withheld scenes are worth points too, if there are any.
pub fn withheld_in_words(outcome: &Outcome) -> Option<String> {
    let (possible, all) = (outcome.possible, outcome.possible + outcome.withheld);
    let words = "can be earned here; the rest are for scenes that are used only in grading";
    (outcome.withheld > 0).then(|| format!("{possible} of {all} points {words}"))
}

/// A scene in one line.
pub fn scene_in_words(scene: &SceneOutcome) -> String {
    match &scene.outcome {
        FilmOutcome::Judged(comparison) if comparison.passes => {
            let exempt = match comparison.exempt {
                0 => String::new(),
                some => format!(", {some} exempt"),
            };
            let seconds = scene.seconds.map(|seconds| format!(", {seconds:.2} s"));
            let seconds = seconds.unwrap_or_default();
            format!("{} pixels{exempt}{seconds}", comparison.resolution)
        }
        other => outcome(other),
    }
}

/// How an answer to a task of an earlier assignment was used, in one line.
pub fn earlier_in_words(earlier: &EarlierOutcome) -> String {
    let file = format!("{}.rs", earlier.task);
    match &earlier.problem {
        None => format!(
            "The scenes are rendered with your {file} from `{}`.",
            earlier.assignment
        ),
        Some(problem) if earlier.is_needed => format!(
            "Your {file} from `{}` is wrong: {}. The scenes are rendered with it all the same, because \
             your other answers don't compile with ours.",
            earlier.assignment,
            printable(problem)
        ),
        Some(problem) => format!(
            "Your {file} from `{}` is not used, because {}. The scenes are rendered with ours instead.",
            earlier.assignment,
            printable(problem)
        ),
    }
}

/// A group in one line.
pub fn group_in_words(group: &GroupOutcome) -> String {
    let said = outcome_of(&group.outcome, "answers");
    match group.fails_fresh {
        true => format!(
            "{said}. Your answers to the public questions pass, but your answers to fresh \
             questions, which students can't see, do not. Ask your instructor, who can look at \
             these questions"
        ),
        false => said,
    }
}

/// The outcome of a film, in one line.
pub fn outcome(outcome: &FilmOutcome) -> String {
    outcome_of(outcome, "pixels")
}

/// Why one question got no answer, in one line.
pub fn no_answer(why: &NoAnswer) -> String {
    match why {
        NoAnswer::NoRay => "there is no ray to ask about".into(),
        NoAnswer::NoFile(file) => format!("there is no usable {file}"),
        NoAnswer::DoesNotCompile(file) => format!("{file} does not compile"),
        NoAnswer::Failed(failure) => outcome(failure),
        NoAnswer::Nothing => "your code gave no answer".into(),
    }
}

/// The outcome of a film with this verdict, in one line.
pub fn outcome_of(outcome: &FilmOutcome, what: &str) -> String {
    match outcome {
        FilmOutcome::Judged(comparison) => verdict_in_words(comparison, what),
        FilmOutcome::Refused { why } => format!("refused: {}", printable(why)),
        FilmOutcome::Unanswered => "unanswered".into(),
        FilmOutcome::Blocked { by } => format!("blocked by `{by}`"),
        FilmOutcome::Panicked {
            message,
            file,
            line,
        } => {
            let (file, message) = (printable(file), printable(message));
            format!("your code panicked at {file}:{line}: {message}")
        }
        FilmOutcome::TimedOut {
            seconds,
            whole: false,
        } => format!("gave no answer within {seconds:.0} s"),
        FilmOutcome::TimedOut { seconds, .. } => {
            format!("not answered in the {seconds:.0} s that the whole submission may take")
        }
        FilmOutcome::OutOfMemory { most } => {
            format!("your program used more than {} MiB of memory", most >> 20)
        }
        FilmOutcome::Died { how } => format!("your program did not finish: {}", printable(how)),
        FilmOutcome::Garbled { why } => {
            let why = printable(why);
            format!("your program's answers could not be read: {why}")
        }
        FilmOutcome::Examples { says, .. } => printable(says),
        FilmOutcome::Withheld { passes: true, .. } => "passes".into(),
        FilmOutcome::Withheld {
            points_only: true, ..
        } => "does not pass; what was asked is withheld".into(),
        FilmOutcome::Withheld { ended, .. } => match ended {
            Status::Graded => "is wrong; details are withheld",
            Status::Panicked => "your code panicked; details are withheld",
            Status::Killed => "your program did not finish; details are withheld",
            Status::TimedOut => "gave no answer in time",
            Status::OutOfMemory => "asked for too much memory",
            _ => "your program's answers could not be read",
        }
        .into(),
    }
}

/// A question for the terminal, with its labels in a column of their own.
pub fn facts(facts: &[Fact]) -> String {
    let rows = facts.iter().map(|fact| {
        // A fact may hold what a student's code printed.
        let lines: Vec<String> = fact.text.lines().map(printable).collect();
        let text = lines.join("\n          ");
        format!("{:<9} {text}", fact.label)
    });
    rows.collect::<Vec<_>>().join("\n")
}

/// A verdict in one line. `what` names the film's pixels.
fn verdict_in_words(comparison: &Comparison, what: &str) -> String {
    match comparison.failing {
        0 => "passes".into(),
        1 => format!("1 of {} {what} is wrong", comparison.pixels),
        wrong => format!("{wrong} of {} {what} are wrong", comparison.pixels),
    }
}

/// A diagnosis in lines, without the hints.
pub fn diagnosis(diagnosis: &Diagnosis) -> String {
    let mut lines = Vec::new();
    if diagnosis.reading == Reading::OneOf {
        lines.push(
            "One of these beliefs explains what is wrong here, but the answers don't show which:"
                .into(),
        );
    }
    for Explanation {
        mistake, explained, ..
    } in &diagnosis.beliefs
    {
        let belief = &mistake.belief;
        lines.push(match diagnosis.reading {
            Reading::OneOf => format!("- “{belief}”"),
            Reading::Together => format!(
                "You may believe: “{belief}” That explains {} is wrong here.",
                share(*explained, diagnosis)
            ),
        });
    }
    lines.join("\n")
}

/// How much one belief of a diagnosis explains: “98 % of”, “part of”. If several beliefs together
/// explain what is wrong, no shares are given, because an answer that two of them spoil is in
/// neither share, and it would look as if a third belief were missing. A small share isn't given
/// either. In that case, the belief was named for one part of the answers, such as t, but the share
/// counts only answers in which every part agrees.
pub fn share(explained: f64, diagnosis: &Diagnosis) -> String {
    match (diagnosis.beliefs.len(), diagnosis.reading) {
        (2.., Reading::Together) => "part of what".into(),
        (1, Reading::Together) if explained < 0.5 => "part of what".into(),
        _ => share_of_what(explained),
    }
}

/// A share of “what is wrong”. It is “all that is wrong” only if the share is exactly 1.
pub fn share_of_what(share: f64) -> String {
    match share {
        share if share >= 1.0 => "all that".into(),
        share => format!("{:.0} % of what", (share * 100.0).clamp(1.0, 99.0)),
    }
}
