//! All records of a class together.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use super::alike::{Alike, Known};
use super::intake::Entry;
use super::record::Record;
use super::roster::{Person, Placed};
use pinhole_course::diagnosis::Reading;
use pinhole_course::outcome::Status;

/// The file of a graded class that holds its roll, for merges to read.
pub const ROLL: &str = "roll.json";

/// What was handed in and whose it is: the same in every shard.
#[derive(Clone, Debug, Default, Deserialize, PartialEq, Serialize)]
pub struct Roll {
    /// Everything that is graded, by id.
    pub entries: Vec<Entry>,
    pub placed: Placed,
    /// Files that are no submissions.
    pub ignored: Vec<String>,
}

/// A class, graded.
pub struct Class<'a> {
    pub title: String,
    pub roll: &'a Roll,
    /// In the order of the roll; `None` if there is no grade and no record of a fault.
    pub rows: Vec<Row<'a>>,
    pub alike: Vec<Alike>,
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
pub struct Held {
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
        known: &Known,
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

    /// Those without a mark, and why.
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

    /// Who ended how.
    pub fn outcomes(&self) -> BTreeMap<Status, Vec<&'a str>> {
        let mut outcomes: BTreeMap<Status, Vec<&str>> = BTreeMap::new();
        for row in &self.rows {
            let status = row.record.map_or(Status::NotGraded, |record| record.status);
            outcomes.entry(status).or_default().push(&row.entry.id);
        }
        outcomes
    }

    /// What is believed, the commonest first. A belief that several explain alike is
    /// counted only where it is told apart.
    pub fn mistakes(&self) -> Vec<Held> {
        let mut held: BTreeMap<&str, Held> = BTreeMap::new();
        for record in self.graded() {
            let tasks = record.got.tasks.iter();
            for task in tasks.filter(|task| task.diagnosis.reading == Reading::Together) {
                for belief in &task.diagnosis.beliefs {
                    let entry = held.entry(&belief.slug).or_insert_with(|| Held {
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
        let mut held: Vec<Held> = held.into_values().collect();
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
