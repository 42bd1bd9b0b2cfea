//! Groups wrong answers that no known mistake explains. If several answers are wrong in the
//! same way, a mistake may be missing from the catalogue.

use std::collections::BTreeMap;

use pinhole::Fact;
use serde::Serialize;

use super::record::Record;
use pinhole_course::outcome::{FilmOutcome, TaskOutcome};

/// Answers to one task that are wrong in the same way.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct UnexplainedGroup {
    pub task: String,
    /// The ids of the submissions with these answers.
    pub who: Vec<String>,
    /// What is measurably wrong in them.
    pub measured: Vec<String>,
    /// The groups of questions that fail, and how many of each.
    pub failing: Vec<String>,
    /// One question that shows it: what was asked, expected and given.
    pub example: Vec<Fact>,
    /// A `mistake.toml` to finish.
    pub draft: String,
}

/// The unexplained answers of a class, the largest groups first. Two answers belong together if
/// they fail equally many questions of the same groups and measuring them gives the same
/// sentences.
pub fn groups<'a>(records: impl Iterator<Item = &'a Record>) -> Vec<UnexplainedGroup> {
    let mut groups: BTreeMap<(String, Vec<String>, Vec<String>), UnexplainedGroup> =
        BTreeMap::new();
    for record in records {
        let tasks = record.got.tasks.iter();
        let unexplained = tasks.filter(|task| {
            task.diagnosis.is_empty() && !task.measured.is_empty() && !task.passes()
        });
        for task in unexplained {
            let failing = failing(task);
            let measured: Vec<String> = task.measured.iter().map(|it| it.says.clone()).collect();
            let key = (task.name.clone(), failing.clone(), measured.clone());
            let group = groups.entry(key).or_insert_with(|| UnexplainedGroup {
                task: task.name.clone(),
                who: Vec::new(),
                draft: draft(task, &measured),
                example: example(task),
                measured,
                failing,
            });
            group.who.push(record.id.clone());
        }
    }
    let mut groups: Vec<UnexplainedGroup> = groups.into_values().collect();
    groups.sort_by_key(|group| std::cmp::Reverse(group.who.len()));
    groups
}

fn failing(task: &TaskOutcome) -> Vec<String> {
    let groups = task.groups.iter().filter(|group| !group.outcome.passes());
    let in_words = groups.map(|group| match &group.outcome {
        FilmOutcome::Judged(comparison) => format!("{} ({})", group.name, comparison.failing),
        other => format!("{} ({})", group.name, other.status().word()),
    });
    in_words.collect()
}

fn example(task: &TaskOutcome) -> Vec<Fact> {
    let mut shown = task.groups.iter().filter(|group| !group.worst.is_empty());
    shown.next().map_or(Vec::new(), |group| group.worst.clone())
}

/// A draft of `mistake.toml`, to be placed beside the wrong answer file.
fn draft(task: &TaskOutcome, measured: &[String]) -> String {
    let comments: Vec<String> = measured.iter().map(|says| format!("# {says}")).collect();
    let quoted = |text: &str| toml::Value::from(text).to_string();
    format!(
        "# Measurement in the answers to {}:\n{}\nbelief = \"I …\"\nfails = [{}]\nchapter = {}\n\n\
         [hint]\nlook = \"…\"\nthink = \"…\"\nread = \"a section of the chapter\"\n",
        task.name,
        comments.join("\n"),
        quoted(&task.name),
        quoted(&task.chapter),
    )
}
