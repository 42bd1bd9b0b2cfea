//! A task on the page.

use serde::Serialize;

use super::belief::Beliefs;
use crate::escape::printable;
use crate::passage::Passage;
use crate::terminal;
use pinhole::Fact;
use pinhole_course::outcome::{AnswerFile, GroupOutcome, TaskOutcome};

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

impl TaskSection {
    /// The `k`-th task; `again` is the command that examined it.
    pub fn of(k: usize, task: &TaskOutcome, again: &str) -> TaskSection {
        let compiler = match &task.file {
            AnswerFile::DoesNotCompile { compiler } => Some(plain(compiler)),
            _ => None,
        };
        let replaced = task.file != AnswerFile::Compiled;
        TaskSection {
            id: format!("task-{k}"),
            name: task.name.clone(),
            passes: task.points == task.possible,
            earned: task.points,
            possible: task.possible,
            said: terminal::task_in_words(task),
            attempted: replaced || !task.is_unanswered(),
            replaced,
            groups: rows(task),
            compiler,
            beliefs: Beliefs::of(&task.diagnosis, &[]),
            chapter: Passage::chapter(&task.chapter),
            command: format!("{again} --task {}", task.name),
        }
    }
}

/// The groups of a task; a panic in every group is one panic.
fn rows(task: &TaskOutcome) -> Vec<GroupRow> {
    let mut told: Vec<String> = Vec::new();
    let row = |group: &GroupOutcome| {
        let said = terminal::group_in_words(group);
        let again = group.worst.is_empty() && told.contains(&said);
        told.push(said.clone());
        GroupRow {
            name: group.name.clone(),
            passes: group.outcome.passes(),
            worth: group.possible,
            said: if again { "the same".into() } else { said },
            worst: group.worst.clone(),
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_compilers_colours_and_what_hides_its_neighbours_stay_out() {
        assert_eq!(
            plain("\u{1b}[31merror\u{1b}[0m: a\u{202e}b\n"),
            "error: a\\u{202e}b"
        );
    }
}
