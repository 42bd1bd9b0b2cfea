//! Counts the mistakes that each group of questions and each scene catches, and those
//! that nothing else catches.

use serde::Serialize;

use super::mutants::Mutants;
use super::submissions::SubmissionVerdict;
use super::validator::Validator;
use pinhole_course::assignment::GroupPoints;

/// Rows for groups of questions and, separately, for scenes.
#[derive(Debug, Serialize)]
pub struct DetectionTable {
    /// How many single mistakes were judged.
    pub mistakes: usize,
    /// How many mutants were caught by their own task's questions; `None` if none were
    /// judged.
    pub mutants: Option<usize>,
    /// Groups of questions, in the assignment's order.
    pub probes: Vec<DetectionRow>,
    /// Scenes, in the assignment's order.
    pub scenes: Vec<DetectionRow>,
}

/// What one group of questions or one scene catches. Only single mistakes are counted, because a
/// combined mistake fails wherever one of its beliefs does.
#[derive(Debug, Default, Serialize)]
pub struct DetectionRow {
    /// `task.group`, or the scene.
    pub name: String,
    /// How many mistakes fail here.
    pub mistakes: usize,
    /// Mistakes that fail in no other group, or, for a scene, in no other scene.
    pub only_of_its_kind: Vec<String>,
    /// Mistakes that fail nowhere else at all.
    pub only: Vec<String>,
    /// How many mutants fail in this group.
    pub mutants: usize,
    /// How many of them fail in no other group.
    pub mutants_only: usize,
}

impl DetectionTable {
    /// Counts single mistakes and mutants.
    pub fn count(
        validator: &Validator,
        judged: &[SubmissionVerdict],
        mutants: Option<&Mutants>,
    ) -> DetectionTable {
        let single: Vec<&SubmissionVerdict> =
            judged.iter().filter(|judged| judged.single).collect();
        let by_group = mutants.map(Mutants::by_group).unwrap_or_default();
        let groups = validator.assignment.tasks.iter().flat_map(|task| {
            let named = |points: &GroupPoints| format!("{}.{}", task.name, points.group);
            task.points.iter().map(named)
        });
        let group = |name: String| {
            let (mutants, mutants_only) = by_group.get(name.as_str()).copied().unwrap_or((0, 0));
            DetectionRow {
                mutants,
                mutants_only,
                ..DetectionRow::count(name, &single, |judged| &judged.groups)
            }
        };
        let scenes = validator.goldens.scenes.iter();
        let scene = |name| DetectionRow::count(name, &single, |judged| &judged.scenes);
        DetectionTable {
            mistakes: single.len(),
            mutants: mutants.map(|mutants| mutants.count(|judged| judged.groups().is_some())),
            probes: groups.map(group).collect(),
            scenes: scenes.map(|golden| scene(golden.name.clone())).collect(),
        }
    }
}

impl DetectionRow {
    fn count(
        name: String,
        judged: &[&SubmissionVerdict],
        kind: impl Fn(&SubmissionVerdict) -> &Vec<String>,
    ) -> DetectionRow {
        let here: Vec<&&SubmissionVerdict> = judged
            .iter()
            .filter(|judged| kind(judged).contains(&name))
            .collect();
        let names = |keep: &dyn Fn(&SubmissionVerdict) -> bool| {
            let kept = here.iter().filter(|judged| keep(judged));
            kept.map(|judged| judged.name.clone()).collect()
        };
        DetectionRow {
            mistakes: here.len(),
            only_of_its_kind: names(&|judged| kind(judged).len() == 1),
            only: names(&|judged| judged.groups.len() + judged.scenes.len() == 1),
            name,
            ..DetectionRow::default()
        }
    }
}
