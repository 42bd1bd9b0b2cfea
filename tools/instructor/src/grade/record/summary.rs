//! The small part of a record that the tables and pages of a class need. Without the rest, a class
//! of many thousands fits into memory.

use pinhole::Fact;

use super::Record;
use pinhole_course::diagnosis::Reading;
use pinhole_course::outcome::{FilmOutcome, Status, TaskOutcome};

/// A record without the parts that only its own student reads.
#[derive(Clone, Debug)]
pub struct RecordSummary {
    pub id: String,
    pub status: Status,
    /// See [`Record::explanation`]; empty if there is a mark.
    pub explanation: String,
    pub points: Option<u32>,
    pub possible: u32,
    pub tasks: Vec<TaskSummary>,
    pub scenes: Vec<PartSummary>,
    /// See [`Record::scene_points`].
    pub scene_points: (u32, u32),
    /// See [`Record::notes`].
    pub notes: String,
    /// How many places in its answers the instructor may want to look at.
    pub flags: usize,
    pub judged_on: String,
    /// How long grading took.
    pub seconds: f64,
    /// See [`Record::tokens`]. A map would take three times the memory.
    pub tokens: Box<[(String, String)]>,
}

/// A task, a group of questions or a scene.
#[derive(Clone, Debug)]
pub struct PartSummary {
    pub name: Box<str>,
    pub points: u32,
    pub possible: u32,
    pub status: Status,
}

#[derive(Clone, Debug)]
pub struct TaskSummary {
    pub task: PartSummary,
    pub groups: Box<[PartSummary]>,
    /// The mistakes behind it, with the belief of each. Lists only mistakes that can be told apart
    /// from others that would explain the same errors.
    pub mistakes: Vec<(String, String)>,
    pub unexplained: Option<Box<UnexplainedAnswer>>,
}

/// A wrong answer that was measured, and that no known mistake explains.
#[derive(Clone, Debug)]
pub struct UnexplainedAnswer {
    pub chapter: String,
    /// What is measurably wrong in it.
    pub measured: Vec<String>,
    /// The groups of questions that fail, each with its number of failing questions.
    pub failing: Vec<String>,
    /// One question that shows it: what was asked, expected and given.
    pub example: Vec<Fact>,
}

impl RecordSummary {
    /// Whether it has a mark.
    pub fn is_graded(&self) -> bool {
        self.points.is_some()
    }
}

impl From<Record> for RecordSummary {
    fn from(record: Record) -> RecordSummary {
        let explanation = match record.is_graded() {
            true => String::new(),
            false => record.explanation.clone(),
        };
        let scenes = record.got.scenes.iter().map(|scene| PartSummary {
            name: scene.name.as_str().into(),
            points: scene.points,
            possible: scene.possible,
            status: scene.outcome.status(),
        });
        RecordSummary {
            status: record.status,
            explanation,
            points: record.got.points,
            possible: record.got.possible,
            tasks: record.got.tasks.iter().map(task).collect(),
            scenes: scenes.collect(),
            scene_points: record.scene_points(),
            notes: record.notes(),
            flags: record.got.flags.len(),
            judged_on: record.provenance.made_with.judged_on,
            seconds: record.timings.total,
            tokens: record.tokens.into_iter().collect(),
            id: record.id,
        }
    }
}

fn task(task: &TaskOutcome) -> TaskSummary {
    let groups = task.groups.iter().map(|group| PartSummary {
        name: group.name.as_str().into(),
        points: group.points,
        possible: group.possible,
        status: group.outcome.status(),
    });
    let beliefs = match task.diagnosis.reading {
        Reading::Together => &task.diagnosis.beliefs[..],
        Reading::OneOf => &[],
    };
    let mistakes = beliefs
        .iter()
        .map(|held| (held.slug.clone(), held.mistake.belief.clone()));
    TaskSummary {
        task: PartSummary {
            name: task.name.as_str().into(),
            points: task.points,
            possible: task.possible,
            status: task.status(),
        },
        groups: groups.collect(),
        mistakes: mistakes.collect(),
        unexplained: unexplained(task).map(Box::new),
    }
}

fn unexplained(task: &TaskOutcome) -> Option<UnexplainedAnswer> {
    if !task.diagnosis.is_empty() || task.measured.is_empty() || task.passes() {
        return None;
    }
    let failing = task.groups_of_questions();
    let failing = failing.filter(|group| !group.outcome.passes());
    let failing = failing.map(|group| match &group.outcome {
        FilmOutcome::Judged(comparison) => format!("{} ({})", group.name, comparison.failing),
        other => format!("{} ({})", group.name, other.status().word()),
    });
    let groups = task.groups_of_questions();
    let mut shown = groups.filter(|group| !group.worst.is_empty());
    Some(UnexplainedAnswer {
        chapter: task.chapter.clone(),
        measured: task.measured.iter().map(|it| it.says.clone()).collect(),
        failing: failing.collect(),
        example: shown.next().map_or(Vec::new(), |group| group.worst.clone()),
    })
}
