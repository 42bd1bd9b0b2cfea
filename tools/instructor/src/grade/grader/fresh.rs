//! Questions that nobody has seen, the same for the whole class, and what they take from
//! what the known ones gave.
//!
//! Whoever has the public goldens could write them into the answer files. Probes and
//! scenes from a fresh seed cannot be known before they are made.

use std::fs;
use std::hash::{BuildHasher, RandomState};
use std::path::Path;

use crate::golden;
use crate::golden::arguments::GoldenRender;
use crate::grade::record::Record;
use pinhole_course::assignment::Assignment;
use pinhole_course::checkout::Checkout;
use pinhole_course::error::{Error, Result, ResultExt};
use pinhole_course::examine::Selection;
use pinhole_course::goldens::Goldens;
use pinhole_course::manifest::Manifest;
use pinhole_course::mitsuba;
use pinhole_course::outcome::{GroupOutcome, Outcome, TaskOutcome};
use pinhole_course::run_options::AssignmentOption;

/// The fresh goldens in `folder`, made if they are not there; `None` if there is no
/// Mitsuba to make them.
pub fn find_or_make(
    folder: &Path,
    seed: Option<u64>,
    assignment: &Assignment,
    checkout: &Checkout,
) -> Result<Option<(Goldens, u64)>> {
    let kept = Manifest::read(folder)
        .ok()
        .and_then(|manifest| manifest.probe_seed);
    let same = kept.filter(|kept| seed.is_none_or(|seed| seed == *kept));
    if let Some(seed) = same {
        return Ok(Some((Goldens::read(folder, assignment)?, seed)));
    }
    if !mitsuba::is_there(checkout) {
        return match seed {
            Some(_) => Err(Error::environment(
                "there is no Mitsuba here to make fresh questions with",
                "make its environment: cargo pinhole golden setup, or pass --no-fresh",
            )),
            None => Ok(None),
        };
    }
    let seed = seed.unwrap_or_else(chosen);
    anstream::eprintln!("making fresh questions with Mitsuba, seed {seed} …");
    // Complete or not there at all, whenever we are killed.
    let beside = folder.with_extension("new");
    let _left_behind = fs::remove_dir_all(&beside);
    let request = GoldenRender {
        assignment: AssignmentOption::default(),
        scenes: Vec::new(),
        out: Some(beside.clone()),
        seed: Some(seed),
        no_mistakes: true,
    };
    golden::make(assignment, checkout, &request)?;
    let _of_another_seed = fs::remove_dir_all(folder);
    fs::rename(&beside, folder).or_environment(
        format_args!("cannot keep fresh questions in {}", folder.display()),
        "check that the folder can be written",
    )?;
    Ok(Some((Goldens::read(folder, assignment)?, seed)))
}

/// The tasks and scenes that fresh questions could still cost something.
pub fn worth_asking_fresh(outcome: &Outcome) -> Option<Selection> {
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

/// A seed that nobody can guess: the system's own randomness.
fn chosen() -> u64 {
    RandomState::new().hash_one(std::process::id()) >> 33
}
