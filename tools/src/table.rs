//! An examination as a table for people.

use anstyle::{AnsiColor, Style};
use pinhole::judge::{ChannelVerdict, Verdict};

use crate::compile::Replaced;
use crate::describe::{printable, printable_coloured};
use crate::diagnosis::{Diagnosis, Explanation, Reading};
use crate::examination::{Examination, GroupResult, Outcome, SceneResult, TaskResult};
use crate::passage::Passage;
use crate::shell::in_shell;
use crate::submission::Unusable;

pub const PASS: Style = AnsiColor::Green.on_default();
pub const FAIL: Style = AnsiColor::Red.on_default();
pub const QUIET: Style = AnsiColor::BrightBlack.on_default();
pub const STRONG: Style = Style::new().bold();

/// How the words for a time-out begin.
pub const NO_ANSWER: &str = "gave no answer within";

/// Lines of a student's own output that are shown.
const MOST_PRINTED_LINES: usize = 20;

/// The whole table: tasks, scenes, what went wrong, and the sum of points.
pub fn examination(examination: &Examination) -> String {
    let mut text = String::new();
    let submission = printable(&examination.submission);
    line(
        &mut text,
        format!(
            "{STRONG}{}{STRONG:#}  {QUIET}{submission}{QUIET:#}",
            examination.title
        ),
    );
    let tasks = examination.tasks.iter().map(|task| &task.name);
    let names = tasks.chain(examination.scenes.iter().map(|scene| &scene.name));
    let width = names.map(String::len).max().unwrap_or(0).max(5) + 2;
    if !examination.tasks.is_empty() {
        line(&mut text, heading("task", width));
    }
    for task in &examination.tasks {
        task_rows(&mut text, task, width, Extent::All);
    }
    scene_table(&mut text, examination, width);
    let (earned, possible) = examination.points();
    line(
        &mut text,
        format!(
            "\n{STRONG}  {:<width$}{earned:>3} / {possible}{STRONG:#}",
            "total"
        ),
    );
    if let Some(words) = examination.withheld_in_words() {
        line(&mut text, format!("  {QUIET}{words}{QUIET:#}"));
    }
    text.push_str(&printed(&examination.printed));
    text
}

/// One task with the first of its groups that fails; `width` is that of its name.
pub fn task(task: &TaskResult, width: usize) -> String {
    let mut text = String::new();
    task_rows(&mut text, task, width, Extent::First);
    text
}

/// The scenes.
pub fn scenes(examination: &Examination) -> String {
    let mut text = String::new();
    let names = examination.scenes.iter().map(|scene| scene.name.len());
    scene_table(&mut text, examination, names.max().unwrap_or(0) + 2);
    text
}

/// What a student's code printed, cut to its beginning; nothing for nothing.
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
                format!("  … and {} lines more", lines.len() - MOST_PRINTED_LINES),
            );
        }
    }
    text
}

fn line(text: &mut String, line: String) {
    text.push_str(&line);
    text.push('\n');
}

fn heading(what: &str, width: usize) -> String {
    format!("\n{QUIET}  {what:<width$}points{QUIET:#}")
}

/// One line of the table; `width` is that of the names' column.
fn row(text: &mut String, name: &str, width: usize, points: (u32, u32), said: String) {
    let (earned, possible) = points;
    let full = earned == possible;
    let (style, mark) = if full { (PASS, "✓") } else { (FAIL, "✗") };
    line(
        text,
        format!("{style}{mark}{style:#} {name:<width$}{earned:>3} / {possible:<4} {said}"),
    );
}

/// How much is told of a task that fails.
#[derive(Clone, Copy, PartialEq)]
enum Extent {
    /// Every failing group, and where to look.
    All,
    /// The first failing group; hints are for whoever asks.
    First,
}

fn task_rows(text: &mut String, task: &TaskResult, width: usize, extent: Extent) {
    let failing: Vec<&GroupResult> = task
        .groups
        .iter()
        .filter(|group| !group.outcome.passes())
        .collect();
    row(text, &task.name, width, task.points(), task_in_words(task));
    if let Some(Replaced::DoesNotCompile(diagnostics)) = &task.replaced {
        indent(text, &printable_coloured(diagnostics.trim_end()));
    }
    for row in diagnosis(&task.diagnosis).lines() {
        line(text, format!("    {STRONG}{row}{STRONG:#}"));
    }
    let hinted = match extent {
        Extent::All => task.diagnosis.beliefs.as_slice(),
        Extent::First => &[],
    };
    for Explanation { mistake, .. } in hinted {
        line(text, format!("    look: {}", mistake.hint.look));
    }
    if task.replaced.is_none() && !task.is_unanswered() {
        let most = match extent {
            Extent::All => failing.len(),
            Extent::First => 1,
        };
        let mut told: Vec<String> = Vec::new();
        for group in failing.iter().take(most) {
            let said = outcome_of(&group.outcome, "questions");
            // A panic in every group is one panic.
            let said = if group.worst.is_none() && told.contains(&said) {
                "the same".into()
            } else {
                said
            };
            line(text, format!("    {FAIL}{:<18}{FAIL:#}{said}", group.name));
            // Where the belief is known, one question shows enough of it.
            if let Some(worst) = &group.worst
                && (task.diagnosis.is_empty() || told.is_empty())
            {
                indent(text, worst);
            }
            told.push(said);
        }
        let others = failing.iter().skip(most).map(|group| group.name.as_str());
        let others: Vec<&str> = others.collect();
        if !others.is_empty() {
            line(
                text,
                format!("    {QUIET}and also: {}{QUIET:#}", others.join(", ")),
            );
        }
    }
    if !failing.is_empty() {
        for passage in Passage::against(&task.diagnosis, &task.chapter) {
            line(text, format!("    {QUIET}read: {passage}{QUIET:#}"));
        }
    }
}

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

/// Beliefs that a task's row spelled out already are only counted.
fn scene_diagnosis(text: &mut String, of_scene: &Diagnosis, known_by_tasks: bool) {
    if !known_by_tasks {
        indent(text, &diagnosis(of_scene));
        return;
    }
    for Explanation {
        mistake, explained, ..
    } in &of_scene.beliefs
    {
        let tasks = mistake.fails.join(", ");
        let share = percent(*explained);
        indent(
            text,
            &format!("what you believe in {tasks} explains {share} of it"),
        );
    }
}

fn scene_table(text: &mut String, examination: &Examination, width: usize) {
    if !examination.scenes.is_empty() {
        line(text, heading("scene", width));
    }
    let known = examination.tasks.iter().any(|task| !task.passes());
    for scene in &examination.scenes {
        scene_rows(text, scene, width, &examination.submission, known);
    }
}

fn scene_rows(
    text: &mut String,
    scene: &SceneResult,
    width: usize,
    submission: &str,
    known_by_tasks: bool,
) {
    let passes = scene.outcome.passes();
    let earned = if passes { scene.worth } else { 0 };
    row(
        text,
        &scene.name,
        width,
        (earned, scene.worth),
        scene_in_words(scene),
    );
    if let Outcome::Judged(verdict) = &scene.outcome
        && let Some((channel, mismatch)) = worst_pixel(verdict)
    {
        let rows = verdict
            .channels
            .iter()
            .filter(|channel| channel.failing > 0)
            .map(ToString::to_string);
        indent(text, &rows.collect::<Vec<_>>().join("\n"));
        scene_diagnosis(text, &scene.diagnosis, known_by_tasks);
        let (i, j) = (mismatch.i, mismatch.j);
        let (name, folder) = (in_shell(&scene.argument), in_shell(submission));
        let command =
            format!("cargo run --release -- explain {name} {i} {j} --submission {folder}");
        line(
            text,
            format!("    {QUIET}look at {}: {command}{QUIET:#}", channel.name),
        );
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

/// The pixel to look at first, and the channel it is wrong in.
pub fn worst_pixel(verdict: &Verdict) -> Option<(&ChannelVerdict, pinhole::Pixel)> {
    verdict
        .channels
        .iter()
        .find_map(|channel| Some((channel, channel.worst?.pixel)))
}

/// An outcome in one line.
pub fn outcome(outcome: &Outcome) -> String {
    outcome_of(outcome, "pixels")
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
        Outcome::TimedOut { seconds } => format!("{NO_ANSWER} {seconds:.0} s"),
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

fn indent(text: &mut String, block: &str) {
    for row in block.lines() {
        line(text, format!("      {row}"));
    }
}
