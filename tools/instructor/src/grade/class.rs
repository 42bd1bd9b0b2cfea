//! All records of a class together, and what grading them again has changed.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use super::alike::{KnownAnswers, SharedAnswer};
use super::intake::Entry;
use super::intake::roster::{Person, Placement};
use super::record::Record;
use pinhole_course::diagnosis::Reading;
use pinhole_course::outcome::Status;

/// The file of a graded class that holds its roll, for merges to read.
pub const ROLL: &str = "roll.json";

/// What was handed in and whose it is: the same in every shard.
#[derive(Clone, Debug, Default, Deserialize, PartialEq, Serialize)]
pub struct Roll {
    /// Everything that is graded, by id.
    pub entries: Vec<Entry>,
    pub placed: Placement,
    /// Files that are not submissions.
    pub ignored: Vec<String>,
}

/// A class, graded.
pub struct Class<'a> {
    pub title: String,
    pub roll: &'a Roll,
    /// In the order of the roll; `None` if there is no grade and no record of a fault.
    pub rows: Vec<Row<'a>>,
    pub alike: Vec<SharedAnswer>,
}

/// A submission's line.
#[derive(Clone, Copy)]
pub struct Row<'a> {
    pub entry: &'a Entry,
    pub person: Option<&'a Person>,
    pub record: Option<&'a Record>,
}

/// A belief and who seems to hold it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SharedBelief {
    pub mistake: String,
    pub belief: String,
    pub tasks: Vec<String>,
    pub who: Vec<String>,
}

impl<'a> Class<'a> {
    /// A class of these records, by id.
    pub fn new(
        title: &str,
        roll: &'a Roll,
        records: &'a BTreeMap<String, Record>,
        known: &KnownAnswers,
    ) -> Class<'a> {
        let row = |entry: &'a Entry| Row {
            entry,
            person: roll.placed.of.get(&entry.id),
            record: records.get(&entry.id),
        };
        let rows: Vec<Row> = roll.entries.iter().map(row).collect();
        let all: Vec<&Record> = rows.iter().filter_map(|row| row.record).collect();
        Class {
            title: title.into(),
            roll,
            alike: known.alike(&all),
            rows,
        }
    }

    /// The graded ones.
    pub fn graded(&self) -> impl Iterator<Item = &'a Record> {
        let records = self.rows.iter().filter_map(|row| row.record);
        records.filter(|record| record.is_graded())
    }

    /// The submissions without a mark, and why.
    pub fn not_graded(&self) -> Vec<(&'a str, &'a str)> {
        let without = self.rows.iter().filter_map(|row| match row.record {
            Some(record) if record.is_graded() => None,
            Some(record) => Some((row.entry.id.as_str(), record.explanation.as_str())),
            None => Some((
                row.entry.id.as_str(),
                "it was not graded yet: run the same again",
            )),
        });
        without.collect()
    }

    /// The submissions by how they ended.
    pub fn outcomes(&self) -> BTreeMap<Status, Vec<&'a str>> {
        let mut outcomes: BTreeMap<Status, Vec<&str>> = BTreeMap::new();
        for row in &self.rows {
            let status = row.record.map_or(Status::NotGraded, |record| record.status);
            outcomes.entry(status).or_default().push(&row.entry.id);
        }
        outcomes
    }

    /// The mistakes that submissions make, the commonest first. A mistake is counted only
    /// where it can be told apart from the others that would explain the same.
    pub fn mistakes(&self) -> Vec<SharedBelief> {
        let mut held: BTreeMap<&str, SharedBelief> = BTreeMap::new();
        for record in self.graded() {
            let tasks = record.got.tasks.iter();
            for task in tasks.filter(|task| task.diagnosis.reading == Reading::Together) {
                for belief in &task.diagnosis.beliefs {
                    let entry = held.entry(&belief.slug).or_insert_with(|| SharedBelief {
                        mistake: belief.slug.clone(),
                        belief: belief.mistake.belief.clone(),
                        tasks: Vec::new(),
                        who: Vec::new(),
                    });
                    if !entry.tasks.contains(&task.name) {
                        entry.tasks.push(task.name.clone());
                    }
                    if !entry.who.contains(&record.id) {
                        entry.who.push(record.id.clone());
                    }
                }
            }
        }
        let mut held: Vec<SharedBelief> = held.into_values().collect();
        held.sort_by(|a, b| (b.who.len(), &a.mistake).cmp(&(a.who.len(), &b.mistake)));
        held
    }

    /// The slowest, in seconds.
    pub fn slowest(&self) -> Vec<(&'a str, f64)> {
        let times = self
            .graded()
            .map(|record| (record.id.as_str(), record.timings.total));
        let mut times: Vec<(&str, f64)> = times.collect();
        times.sort_by(|a, b| b.1.total_cmp(&a.1));
        times.truncate(10);
        times
    }
}

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

/// Drops first, since those are asked about: the deepest at the top.
pub fn sort_changes(changes: &mut [Change]) {
    let gain = |change: &Change| i64::from(change.after) - i64::from(change.before);
    changes.sort_by(|a, b| (gain(a), &a.id).cmp(&(gain(b), &b.id)));
}
