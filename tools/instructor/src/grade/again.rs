//! What fresh questions take from what the known ones gave.

use super::record::Record;
use pinhole_course::examine::Selection;
use pinhole_course::outcome::{GroupOutcome, Outcome, TaskOutcome};

/// The tasks and scenes that fresh questions could still cost something.
pub fn worth_asking_again(outcome: &Outcome) -> Option<Selection> {
    let has_points = |task: &&TaskOutcome| task.points > 0;
    let tasks = outcome.tasks.iter().filter(has_points);
    let tasks: Vec<String> = tasks.map(|task| task.name.clone()).collect();
    let scenes = outcome.scenes.iter().any(|scene| scene.outcome.passes());
    match (tasks.is_empty(), scenes) {
        (true, false) => None,
        (_, true) => Some(Selection::default()),
        (false, false) => Some(Selection {
            tasks,
            scenes: Vec::new(),
        }),
    }
}

/// Takes their points from the groups that pass the known questions and fail fresh ones.
pub fn revoke_failing_fresh(outcome: &mut Outcome, fresh: &Outcome) {
    for task in &mut outcome.tasks {
        let Some(again) = fresh.tasks.iter().find(|again| again.name == task.name) else {
            continue;
        };
        for (group, again) in task.groups.iter_mut().zip(&again.groups) {
            if group.outcome.passes() && !again.outcome.passes() {
                *group = GroupOutcome {
                    points: 0,
                    outcome: again.outcome.clone(),
                    worst: again.worst.clone(),
                    fails_fresh: true,
                    ..group.clone()
                };
            }
        }
    }
    outcome.add_up();
}

/// Scenes earn no more than the answers behind them do on questions nobody has seen: the
/// larger of what fresh scenes earn and the tasks' share of their points, rounded up.
/// Fresh scenes alone would be too strict, as one wrong shape spoils all of them.
pub fn most_for_scenes(record: &Record) -> u32 {
    let fresh: u32 = record.fresh_scenes.iter().map(|scene| scene.points).sum();
    let (_, scenes) = record.scene_points();
    let tasks = &record.got.tasks;
    let earned: u32 = tasks.iter().map(|task| task.points).sum();
    let possible: u32 = tasks.iter().map(|task| task.possible).sum();
    fresh.max((scenes * earned).div_ceil(possible.max(1)))
}
