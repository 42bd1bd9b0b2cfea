//! What fresh questions take from what the known ones gave.

use super::record::Record;
use pinhole_course::examination::{Examination, TaskResult};
use pinhole_course::examine::Selection;

/// The tasks and scenes that fresh questions could still cost something.
pub fn worth_asking_again(examination: &Examination) -> Option<Selection> {
    let has_points = |task: &&TaskResult| task.points().0 > 0;
    let tasks = examination.tasks.iter().filter(has_points);
    let tasks: Vec<String> = tasks.map(|task| task.name.clone()).collect();
    let scenes = examination
        .scenes
        .iter()
        .any(|scene| scene.outcome.passes());
    match (tasks.is_empty(), scenes) {
        (true, false) => None,
        (_, true) => Some(Selection::default()),
        (false, false) => Some(Selection {
            tasks,
            scenes: Vec::new(),
        }),
    }
}

/// Takes from `examination` the groups that pass only the questions that were known, and
/// names them: task and group.
pub fn deny(examination: &mut Examination, fresh: &Examination) -> Vec<(String, String)> {
    let mut denied = Vec::new();
    for task in &mut examination.tasks {
        let Some(again) = fresh.tasks.iter().find(|again| again.name == task.name) else {
            continue;
        };
        for (group, again) in task.groups.iter_mut().zip(&again.groups) {
            if group.outcome.passes() && !again.outcome.passes() {
                group.outcome = again.outcome.clone();
                group.worst = again.worst.clone();
                denied.push((task.name.clone(), group.name.clone()));
            }
        }
    }
    denied
}

/// Scenes earn no more than the answers behind them do on questions nobody has seen: the
/// larger of what fresh scenes earn and the tasks' share of their points, rounded up.
/// Fresh scenes alone would be too strict, as one wrong shape spoils all of them.
pub fn most_for_scenes(record: &Record) -> u32 {
    let fresh: u32 = record.fresh_scenes.iter().map(|scene| scene.points).sum();
    let scenes: u32 = record.scenes.iter().map(|scene| scene.possible).sum();
    let earned: u32 = record.tasks.iter().map(|task| task.points).sum();
    let possible: u32 = record.tasks.iter().map(|task| task.possible).sum();
    fresh.max((scenes * earned).div_ceil(possible.max(1)))
}
