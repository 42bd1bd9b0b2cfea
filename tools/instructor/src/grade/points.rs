//! Computes marks from stored outcomes. This is possible because the outcome of a group or a
//! scene doesn't depend on what it is worth.
//!
//! So when points change or a group is dropped, nothing needs to be compiled or asked again.

use super::record::Record;
use crate::scene_cap::most_for_scenes;
use pinhole_course::assignment::{Assignment, DroppedGroup, DroppedPoints};
use pinhole_course::goldens::shares;
use pinhole_course::outcome::{GroupOutcome, SceneOutcome};

/// Gives a graded submission the points that its groups and scenes are now worth.
pub fn compute(record: &mut Record, assignment: &Assignment) {
    let got = &mut record.got;
    for outcome in &mut got.tasks {
        let Some(task) = assignment.task(&outcome.name) else {
            continue;
        };
        for group in &mut outcome.groups {
            let worth = task.all_points().find(|it| it.group == group.name);
            let worth = worth.map_or(group.possible, |points| points.worth);
            give(group, worth, dropped(assignment, &task.name, &group.name));
        }
    }
    let worth = worth_of_scenes(&got.scenes, assignment);
    for (outcome, worth) in got.scenes.iter_mut().zip(worth) {
        outcome.possible = worth;
        outcome.points = match outcome.outcome.passes() {
            true => worth,
            false => 0,
        };
    }
    got.add_up();
    if record.most_for_scenes.is_some() {
        let needs = record.needs.scenes.iter();
        let needs: Vec<Vec<&str>> = needs.map(|names| borrowed(names)).collect();
        let fresh = borrowed(&record.needs.fresh);
        let most = most_for_scenes(got, &record.fresh_scenes, &needs, &fresh);
        record.most_for_scenes = Some(most);
    }
    let by_tasks: u32 = record.got.tasks.iter().map(|task| task.points).sum();
    let points = by_tasks + record.scene_points().0;
    record.got.points = Some(points);
    record.got.passes = points == record.got.possible;
}

/// What each scene is worth: what the assignment says or, if other scenes were cast, an equal
/// share of all its scenes' points.
fn worth_of_scenes(cast: &[SceneOutcome], assignment: &Assignment) -> Vec<u32> {
    let own = &assignment.scenes;
    let of = |outcome: &SceneOutcome| own.iter().find(|scene| scene.name == outcome.name);
    let stated: Option<Vec<u32>> = cast.iter().map(|it| Some(of(it)?.points)).collect();
    match stated.filter(|stated| stated.len() == own.len()) {
        Some(stated) => stated,
        None => shares(
            own.iter().map(|scene| scene.points).sum(),
            cast.len() as u32,
        )
        .collect(),
    }
}

fn borrowed(names: &[String]) -> Vec<&str> {
    names.iter().map(String::as_str).collect()
}

fn give(group: &mut GroupOutcome, worth: u32, dropped: Option<DroppedPoints>) {
    let passes = group.outcome.passes();
    (group.points, group.possible) = match dropped {
        None if passes => (worth, worth),
        None => (0, worth),
        Some(DroppedPoints::Given) => (worth, worth),
        Some(DroppedPoints::Rescaled) => (0, 0),
    };
}

fn dropped(assignment: &Assignment, task: &str, group: &str) -> Option<DroppedPoints> {
    let name = format!("{task}.{group}");
    let mut all = assignment.dropped.iter();
    all.find(|dropped| dropped.group == name)
        .map(|dropped| dropped.points)
}

/// What students read about dropped groups. Empty if there are none.
pub fn dropped_in_words(assignment: &Assignment) -> String {
    let sentence = |dropped: &DroppedGroup| match dropped.points {
        DroppedPoints::Given => format!(
            " {} does not count: everyone gets its points.",
            dropped.group
        ),
        DroppedPoints::Rescaled => format!(
            " {} does not count, and the mark is out of fewer points.",
            dropped.group
        ),
    };
    assignment.dropped.iter().map(sentence).collect()
}

#[cfg(test)]
mod tests {
    use std::path::PathBuf;

    use pinhole_course::assignment::{GroupPoints, ScenePoints, Task};
    use serde_json::{Value, json};

    use super::*;
    use crate::grade::record::tests::graded;

    /// Two groups with these points, and a scene that needs their task.
    fn assignment([edges, front, lone]: [u32; 3], dropped: &[(&str, DroppedPoints)]) -> Assignment {
        let group = |group: &str, worth| GroupPoints {
            group: group.into(),
            worth,
            about: String::new(),
        };
        let dropped = dropped.iter().map(|(group, points)| DroppedGroup {
            group: (*group).into(),
            points: *points,
        });
        Assignment {
            name: "any".into(),
            folder: PathBuf::new(),
            title: "Any".into(),
            start: String::new(),
            tasks: vec![Task {
                name: "triangle".into(),
                kind: pinhole::Kind::Soup,
                shape: None,
                chapter: String::new(),
                points: vec![group("edges", edges), group("front", front)],
                examples: None,
            }],
            scenes: vec![ScenePoints {
                name: "lone".into(),
                points: lone,
                public: true,
            }],
            earlier: None,
            withheld: 0,
            solutions_read: None,
            finish: None,
            dropped: dropped.collect(),
        }
    }

    /// The record of a submission that was asked fresh questions, fails `edges`, and passes
    /// everything else.
    fn record() -> Record {
        let film = |passes: bool| json!({ "kind": "withheld", "passes": passes, "ended": "graded", "points_only": true });
        let group = |name: &str, passes: bool| -> Value {
            json!({
                "name": name, "about": "", "points": 0, "possible": 7, "outcome": film(passes),
                "worst": [], "fails_fresh": !passes,
            })
        };
        let mut record = serde_json::to_value(graded("ada", 0, 0)).expect("it can be written");
        record["tasks"] = json!([{
            "name": "triangle", "chapter": "", "points": 0, "possible": 0,
            "file": { "state": "compiled" }, "diagnosis": null,
            "groups": [group("edges", false), group("front", true)],
        }]);
        record["scenes"] = json!([{
            "name": "lone", "points": 0, "possible": 1, "outcome": film(true),
            "seconds": null, "diagnosis": null,
        }]);
        record["most_for_scenes"] = 0.into();
        record["needs"] = json!({ "scenes": [["triangle"]], "fresh": [] });
        serde_json::from_value(record).expect("a record")
    }

    fn computed(assignment: &Assignment) -> (Option<u32>, u32) {
        let mut record = record();
        compute(&mut record, assignment);
        let once = record.clone();
        compute(&mut record, assignment);
        assert_eq!(record, once, "computing again changes nothing");
        (record.got.points, record.got.possible)
    }

    #[test]
    fn mark_follows_the_points_and_the_scenes_follow_the_tasks() {
        // The task earns 3 of 4 points, so the scene earns three quarters of its own.
        assert_eq!(computed(&assignment([1, 3, 4], &[])), (Some(6), 8));
        // The task earns 1 of 2 points, so the scene earns half of its own.
        assert_eq!(computed(&assignment([1, 1, 10], &[])), (Some(6), 12));
    }

    #[test]
    fn other_scenes_share_the_points_of_the_assignments_scenes() {
        let mut record = record();
        let mut other = record.got.scenes[0].clone();
        other.name = "random_1".into();
        record.got.scenes.push(other);
        compute(&mut record, &assignment([1, 3, 5], &[]));
        let worth = record.got.scenes.iter().map(|scene| scene.possible);
        assert_eq!(worth.collect::<Vec<_>>(), [3, 2]);
    }

    #[test]
    fn dropped_group_gives_its_points_to_everyone_or_raises_the_others() {
        let drop = |points| computed(&assignment([1, 3, 4], &[("triangle.edges", points)]));
        assert_eq!(drop(DroppedPoints::Given), (Some(8), 8));
        assert_eq!(drop(DroppedPoints::Rescaled), (Some(7), 7));
    }

    #[test]
    fn task_without_counted_groups_costs_the_scenes_nothing() {
        let all = ["triangle.edges", "triangle.front"].map(|it| (it, DroppedPoints::Rescaled));
        assert_eq!(computed(&assignment([1, 3, 4], &all)), (Some(4), 4));
    }
}
