//! Marks that have changed.

use serde::Serialize;

use crate::grade::record::Record;

/// A mark that has changed.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Change {
    pub id: String,
    pub before: u32,
    pub after: u32,
    /// The tasks and scenes whose points changed, with the old and the new points.
    pub parts: Vec<(String, u32, u32)>,
    /// Whether the answers themselves have changed.
    pub answers_changed: bool,
}

impl Change {
    /// How `after` differs from `before`; `None` if all points are the same.
    pub fn between(before: &Record, after: &Record) -> Option<Change> {
        let parts = |record: &Record| {
            let tasks = record.got.tasks.iter();
            let tasks = tasks.map(|task| (task.name.clone(), task.points));
            let scenes = ("scenes".to_owned(), record.scene_points().0);
            tasks.chain([scenes]).collect::<Vec<_>>()
        };
        let (Some(points), Some(now)) = (before.got.points, after.got.points) else {
            return None;
        };
        let old = parts(before);
        let had = |name: &String| old.iter().find(|(other, _)| other == name);
        let changed = parts(after).into_iter().filter_map(|(name, now)| {
            let had = had(&name).map_or(0, |(_, points)| *points);
            (had != now).then_some((name, had, now))
        });
        let parts: Vec<(String, u32, u32)> = changed.collect();
        (points != now || !parts.is_empty()).then(|| Change {
            id: after.id.clone(),
            before: points,
            after: now,
            parts,
            answers_changed: before.provenance.answers != after.provenance.answers,
        })
    }

    /// The change, in one line.
    pub fn in_words(&self) -> String {
        let parts = self
            .parts
            .iter()
            .map(|(name, had, has)| format!("{name} {had} → {has}"));
        let parts: Vec<String> = parts.collect();
        let same = match self.answers_changed {
            true => "",
            false => ", from the same answers",
        };
        let (before, after) = (self.before, self.after);
        format!(
            "{}: {before} → {after} ({}){same}",
            self.id,
            parts.join(", ")
        )
    }
}

/// Sorts changes: the largest losses first, because students ask about those.
pub fn sort(changes: &mut [Change]) {
    let gain = |change: &Change| i64::from(change.after) - i64::from(change.before);
    changes.sort_by(|a, b| (gain(a), &a.id).cmp(&(gain(b), &b.id)));
}
