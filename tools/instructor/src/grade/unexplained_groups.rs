//! Groups wrong answers that no known mistake explains. If several answers are wrong in the
//! same way, a mistake may be missing from the catalogue.

use std::collections::BTreeMap;

use pinhole::Fact;
use serde::Serialize;

use super::record::RecordSummary;

/// Answers to one task that are wrong in the same way.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct UnexplainedGroup {
    pub task: String,
    /// The ids of the submissions with these answers.
    pub who: Vec<String>,
    /// What is measurably wrong in them.
    pub measured: Vec<String>,
    /// The groups of questions that fail, each with its number of failing questions.
    pub failing: Vec<String>,
    /// One question that shows it: what was asked, expected and given.
    pub example: Vec<Fact>,
    /// A `mistake.toml` to finish.
    pub draft: String,
}

/// The unexplained answers of a class, the largest groups first. Two answers belong together if
/// they fail equally many questions of the same groups and measuring them gives the same
/// sentences.
pub fn groups<'a>(records: impl Iterator<Item = &'a RecordSummary>) -> Vec<UnexplainedGroup> {
    let mut groups: BTreeMap<(String, Vec<String>, Vec<String>), UnexplainedGroup> =
        BTreeMap::new();
    for record in records {
        for task in &record.tasks {
            let Some(answer) = &task.unexplained else {
                continue;
            };
            let (task, measured) = (task.task.name.to_string(), &answer.measured);
            let key = (task.clone(), answer.failing.clone(), measured.clone());
            let group = groups.entry(key).or_insert_with(|| UnexplainedGroup {
                who: Vec::new(),
                draft: draft(&task, &answer.chapter, measured),
                example: answer.example.clone(),
                measured: measured.clone(),
                failing: answer.failing.clone(),
                task,
            });
            group.who.push(record.id.clone());
        }
    }
    let mut groups: Vec<UnexplainedGroup> = groups.into_values().collect();
    groups.sort_by_key(|group| std::cmp::Reverse(group.who.len()));
    groups
}

/// Stands in a draft for a hint's example. It has no number, so `validate` asks for one.
const EXAMPLE: &str = "a small case in numbers";

/// A draft of `mistake.toml`, to be placed beside the wrong answer file.
fn draft(task: &str, chapter: &str, measured: &[String]) -> String {
    let comments: Vec<String> = measured.iter().map(|says| format!("# {says}")).collect();
    let quoted = |text: &str| toml::Value::from(text).to_string();
    format!(
        "# Measured in the answers to {}:\n{}\nbelief = \"I …\"\nfails = [{}]\nchapter = {}\n\n\
         [hint]\nlook = \"…\"\nthink = \"…\"\nexample = \"{EXAMPLE}\"\n\
         read = \"a section of the chapter\"\n",
        task,
        comments.join("\n"),
        quoted(task),
        quoted(chapter),
    )
}

#[cfg(test)]
mod tests {
    use pinhole_course::mistake::Mistake;

    use super::*;
    use crate::validate::hints::faults_of;

    #[test]
    fn a_draft_is_a_mistake_whose_example_is_still_to_be_written() {
        let draft = draft("sphere", "Sphere", &["t is multiplied by |d|".into()]);
        let mut hint = toml::from_str::<Mistake>(&draft).unwrap().hint;
        assert_eq!(hint.example.as_deref(), Some(EXAMPLE));
        let faults = faults_of(&hint, true);
        assert!(
            faults.len() == 1 && faults[0].contains("`hint.example`"),
            "{faults:?}"
        );
        hint.example = Some("t is 4.".into());
        assert_eq!(faults_of(&hint, true), Vec::<String>::new());
    }
}
