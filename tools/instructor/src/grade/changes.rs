//! What grading again has changed: drops first, since those are asked about.

use serde::Serialize;

use super::csv::Table;
use super::record::Record;

/// A mark that is not what it was.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Change {
    pub id: String,
    pub before: u32,
    pub after: u32,
    /// Tasks and scenes with the points they had and have.
    pub parts: Vec<(String, u32, u32)>,
    /// Whether the answers themselves are others.
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

    /// In a line.
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

/// The deepest drop first.
pub fn sort(changes: &mut [Change]) {
    let gain = |change: &Change| i64::from(change.after) - i64::from(change.before);
    changes.sort_by(|a, b| (gain(a), &a.id).cmp(&(gain(b), &b.id)));
}

/// As a file.
pub fn csv(changes: &[Change]) -> String {
    let mut table = Table::new(&["submission", "before", "after", "what", "answers"]);
    for change in changes {
        let parts = change
            .parts
            .iter()
            .map(|(name, had, has)| format!("{name} {had} to {has}"));
        table.line(&[
            change.id.clone(),
            change.before.to_string(),
            change.after.to_string(),
            parts.collect::<Vec<_>>().join(", "),
            if change.answers_changed {
                "changed"
            } else {
                "the same"
            }
            .into(),
        ]);
    }
    table.text()
}
