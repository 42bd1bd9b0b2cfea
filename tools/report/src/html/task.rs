//! A task on the page.

use serde::Serialize;

use super::belief::Beliefs;
use crate::passage::Passage;
use crate::terminal;
use pinhole_course::compile::Replaced;
use pinhole_course::escape::printable;
use pinhole_course::examination::{GroupResult, TaskResult};

/// One answer, judged alone.
#[derive(Debug, Serialize)]
pub struct TaskSection {
    /// The page's own name for it, so that no name of a task can spoil a link.
    pub id: String,
    pub name: String,
    pub passes: bool,
    pub earned: u32,
    pub possible: u32,
    /// The verdict in a line.
    pub said: String,
    /// Whether anything was answered; if not, there is no more to say.
    pub attempted: bool,
    /// Whether its stub was judged in its place.
    pub replaced: bool,
    pub groups: Vec<GroupRow>,
    /// The compiler's words on its file.
    pub compiler: Option<String>,
    pub beliefs: Option<Beliefs>,
    pub chapter: Passage,
    /// What runs it again.
    pub command: String,
}

/// One group of questions.
#[derive(Debug, Serialize)]
pub struct GroupRow {
    pub name: String,
    pub passes: bool,
    pub worth: u32,
    pub said: String,
    /// The worst question, fact by fact.
    pub worst: Vec<Fact>,
}

/// "expected" and what was.
#[derive(Debug, PartialEq, Serialize)]
pub struct Fact {
    pub label: String,
    pub value: String,
}

impl TaskSection {
    /// The `k`-th task; `again` is the command that examined it.
    pub fn of(k: usize, task: &TaskResult, again: &str) -> TaskSection {
        let (earned, possible) = task.points();
        let passes = earned == possible;
        let compiler = match &task.replaced {
            Some(Replaced::DoesNotCompile(text)) => Some(plain(text)),
            _ => None,
        };
        TaskSection {
            id: format!("task-{k}"),
            name: task.name.clone(),
            passes,
            earned,
            possible,
            said: terminal::task_in_words(task),
            attempted: task.replaced.is_some() || !task.is_unanswered(),
            replaced: task.replaced.is_some(),
            groups: rows(task),
            compiler,
            beliefs: Beliefs::of(&task.diagnosis, &[]),
            chapter: Passage::chapter(&task.chapter),
            command: format!("{again} --task {}", task.name),
        }
    }
}

/// The groups of a task; a panic in every group is one panic.
fn rows(task: &TaskResult) -> Vec<GroupRow> {
    let mut told: Vec<String> = Vec::new();
    let row = |group: &GroupResult| {
        let said = terminal::outcome_of(&group.outcome, "questions");
        let again = group.worst.is_none() && told.contains(&said);
        told.push(said.clone());
        GroupRow {
            name: group.name.clone(),
            passes: group.outcome.passes(),
            worth: group.worth,
            said: if again { "the same".into() } else { said },
            worst: group.worst.as_deref().map(facts).unwrap_or_default(),
        }
    };
    task.groups.iter().map(row).collect()
}

/// The compiler's words without their colours.
fn plain(text: &str) -> String {
    let text = anstream::adapter::strip_str(text.trim_end()).to_string();
    let lines: Vec<String> = text.lines().map(printable).collect();
    lines.join("\n")
}

/// Splits what [`describe::worst`](pinhole_course::describe::worst) lays out for a terminal:
/// labels in the first ten columns, and none where a value goes on.
fn facts(words: &str) -> Vec<Fact> {
    let mut facts: Vec<Fact> = Vec::new();
    for line in words.lines() {
        let split = line.char_indices().nth(10).map_or(line.len(), |(at, _)| at);
        let (label, value) = line.split_at(split);
        match facts.last_mut() {
            Some(fact) if label.trim().is_empty() => {
                fact.value.push('\n');
                fact.value.push_str(value.trim());
            }
            _ => facts.push(Fact {
                label: label.trim().into(),
                value: value.trim().into(),
            }),
        }
    }
    facts
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_question_laid_out_for_terminals_is_taken_apart_again() {
        let words = "camera    perspective, 2 × 1\n          u (1, 0, 0)\nexpected  no hit";
        let fact = |label: &str, value: &str| Fact {
            label: label.into(),
            value: value.into(),
        };
        let expected = [
            fact("camera", "perspective, 2 × 1\nu (1, 0, 0)"),
            fact("expected", "no hit"),
        ];
        assert_eq!(facts(words), expected);
    }

    #[test]
    fn the_compilers_colours_and_what_hides_its_neighbours_stay_out() {
        assert_eq!(
            plain("\u{1b}[31merror\u{1b}[0m: a\u{202e}b\n"),
            "error: a\\u{202e}b"
        );
    }
}
