//! The rows of a task: which beliefs explain what is wrong, and which questions show it.

use super::words::{diagnosis, facts, group_in_words, task_in_words};
use super::{FAIL, QUIET, STRONG, indent, line, row};
use crate::escape::printable_coloured;
use crate::passage::Passage;
use pinhole_course::diagnosis::Explanation;
use pinhole_course::outcome::{AnswerFile, FilmOutcome, GroupOutcome, TaskOutcome};

/// How many lines of the compiler's warnings about a wrong answer are shown. Others may follow
/// from them.
const MOST_WARNING_LINES: usize = 24;

/// How much to say about a task that fails.
#[derive(Clone, Copy, PartialEq)]
pub enum Extent {
    /// Every failing group, and where to look.
    All,
    /// The first failing group, without hints.
    First,
}

/// A task, and why it fails. `width` is that of the column of names.
pub fn rows(text: &mut String, task: &TaskOutcome, width: usize, extent: Extent) {
    let fails = |group: &&GroupOutcome| !group.outcome.passes();
    let failing: Vec<&GroupOutcome> = task.groups.iter().filter(fails).collect();
    let points = (task.points, task.possible);
    row(text, &task.name, width, points, task_in_words(task));
    if let AnswerFile::DoesNotCompile { compiler } = &task.file {
        indent(text, &printable_coloured(compiler.trim_end()));
    }
    for row in diagnosis(&task.diagnosis).lines() {
        line(text, format!("    {STRONG}{row}{STRONG:#}"));
    }
    for finding in &task.measured {
        line(text, format!("    {}", finding.says));
    }
    let hinted = match extent {
        Extent::All => task.diagnosis.beliefs.as_slice(),
        Extent::First => &[],
    };
    for Explanation { mistake, .. } in hinted {
        line(text, format!("    hint: {}", mistake.hint.look));
    }
    let mut shown = failing.clone();
    if task.file != AnswerFile::Compiled || task.is_unanswered() {
        shown.retain(|group| group.is_of_examples());
    }
    if !shown.is_empty() {
        let most = match extent {
            Extent::All => shown.len(),
            Extent::First => 1,
        };
        let (told, others) = shown.split_at(most.min(shown.len()));
        group_rows(text, told, !task.diagnosis.is_empty());
        let others: Vec<&str> = others.iter().map(|group| group.name.as_str()).collect();
        if !others.is_empty() {
            let others = others.join(", ");
            line(text, format!("    {QUIET}also failing: {others}{QUIET:#}"));
        }
    }
    let warnings = task.warnings.lines().take(MOST_WARNING_LINES);
    for warning in warnings {
        indent(text, &printable_coloured(warning));
    }
    if !failing.is_empty() {
        for passage in Passage::against(&task.diagnosis, &task.chapter) {
            line(text, format!("    {QUIET}read: {passage}{QUIET:#}"));
        }
    }
}

/// If no belief explains what is wrong, a question is shown for each of this many failing groups.
/// Otherwise, only for the first.
const MOST_SHOWN: usize = 3;

/// Failing groups, the first of them with a question that shows the failure.
fn group_rows(text: &mut String, failing: &[&GroupOutcome], is_explained: bool) {
    let mut told: Vec<String> = Vec::new();
    let mut left = if is_explained { 1 } else { MOST_SHOWN };
    for group in failing {
        let said = group_in_words(group);
        // A panic in every group is reported once.
        let is_judged = matches!(group.outcome, FilmOutcome::Judged(_));
        let again = !is_judged && told.contains(&said);
        let said = if again { "the same".into() } else { said };
        line(text, format!("    {FAIL}{:<18}{FAIL:#}{said}", group.name));
        if !again && left > 0 {
            indent(text, &facts(&group.worst));
            left -= 1;
        }
        told.push(said);
    }
}
