//! Limits the points of scenes by those of the tasks that they need.
//!
//! A student who has the public goldens could write their pixels or shapes into the answer files.
//! Fresh questions take away the points of such tasks, so the points of tasks limit those of
//! scenes.

use pinhole_course::outcome::{Outcome, SceneOutcome};

/// The most that scenes may earn. Each scene that passes gets its points times the smallest share
/// of points among the tasks it needs, and the sum is rounded up. If the share of fresh scenes that
/// pass is larger, and they need the same tasks, their share counts.
///
/// `needs` says which tasks each scene needs, and which the fresh scenes need together.
pub fn most_for_scenes(
    outcome: &Outcome,
    fresh: &[SceneOutcome],
    needs: &[Vec<&str>],
    fresh_needs: &[&str],
) -> u32 {
    let of_fresh = share(fresh.iter().map(|scene| (scene.outcome.passes().into(), 1)));
    let capped = outcome.scenes.iter().zip(needs).map(|(scene, needs)| {
        let tasks = outcome.tasks.iter();
        // A task whose groups are all dropped doesn't count here.
        let needed = tasks.filter(|task| needs.contains(&task.name.as_str()));
        let points = needed.map(|task| {
            let groups = task.groups_of_questions();
            total(groups.map(|group| (group.points, group.possible)))
        });
        let shares = points.filter(|it| it.1 > 0).map(|it| share([it]));
        let smallest = shares.fold(1.0, f64::min);
        let most = match needs.iter().all(|task| fresh_needs.contains(task)) {
            true => smallest.max(of_fresh),
            false => smallest,
        };
        f64::from(scene.points) * most
    });
    // A sum of thirds may miss a whole number by a rounding error.
    (capped.sum::<f64>() - 1e-9).ceil() as u32
}

/// Earned points divided by possible ones.
fn share(points: impl IntoIterator<Item = (u32, u32)>) -> f64 {
    let (earned, possible) = total(points);
    f64::from(earned) / f64::from(possible.max(1))
}

fn total(points: impl IntoIterator<Item = (u32, u32)>) -> (u32, u32) {
    let points = points.into_iter();
    points.fold((0, 0), |(a, b), (c, d)| (a + c, b + d))
}

#[cfg(test)]
mod tests {
    use serde_json::{Value, json};

    use super::*;

    /// The most for two scenes that pass, if two tasks have earned these points out of 10, and so
    /// many of nine fresh scenes pass, which are worth nothing themselves. The
    /// first scene is worth 3 points and needs both tasks. The second is worth 5 and needs only
    /// `plane`.
    fn most(sphere: u32, plane: u32, fresh: u32, fresh_needs: &[&str]) -> u32 {
        let task = |name: &str, points: u32| {
            let group = |points: u32, possible: u32, outcome: Value| {
                json!({
                    "name": "a", "about": "", "points": points, "possible": possible,
                    "outcome": outcome, "worst": [], "fails_fresh": false,
                })
            };
            // Points for examples that are lost cost the scenes nothing.
            let examples = json!({ "kind": "examples", "passes": false, "says": "" });
            let groups = [
                group(points, 10, json!({ "kind": "unanswered" })),
                group(0, 2, examples),
            ];
            json!({
                "name": name, "chapter": "", "points": points, "possible": 12,
                "file": { "state": "compiled" }, "groups": groups, "diagnosis": null,
            })
        };
        let scene = |name: &str, points: u32, possible: u32| {
            json!({
                "name": name, "points": points, "possible": possible,
                "outcome": { "kind": "unanswered" }, "seconds": null, "diagnosis": null,
            })
        };
        let mut outcome = Outcome::new("title", "ada".into(), "none");
        let tasks = json!([task("sphere", sphere), task("plane", plane)]);
        outcome.tasks = serde_json::from_value(tasks).expect("two tasks");
        let scenes = json!([scene("both", 3, 3), scene("plane", 5, 5)]);
        outcome.scenes = serde_json::from_value(scenes).expect("two scenes");
        let random = (0..9).map(|k| {
            let mut scene = scene("random", 0, 0);
            scene["outcome"] = json!({
                "kind": "withheld", "passes": k < fresh, "ended": "timed out", "points_only": false,
            });
            scene
        });
        let fresh = random.collect();
        let fresh: Vec<SceneOutcome> = serde_json::from_value(fresh).expect("a scene");
        let needs = [vec!["sphere", "plane"], vec!["plane"]];
        most_for_scenes(&outcome, &fresh, &needs, fresh_needs)
    }

    #[test]
    fn scene_earns_the_smallest_share_of_the_tasks_that_it_needs() {
        assert_eq!(most(10, 10, 0, &[]), 8);
        assert_eq!(most(0, 10, 0, &[]), 5);
        assert_eq!(most(10, 0, 0, &[]), 0);
        // 3 × 0.3 + 5 × 0.9 = 5.4
        assert_eq!(most(3, 9, 0, &[]), 6);
    }

    #[test]
    fn fresh_scenes_count_only_for_the_tasks_that_they_need() {
        assert_eq!(most(0, 0, 9, &["sphere", "plane"]), 8);
        assert_eq!(most(0, 0, 9, &["plane"]), 5);
        assert_eq!(most(10, 10, 0, &["sphere", "plane"]), 8);
    }
}
