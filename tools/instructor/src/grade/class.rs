//! All records of a class.

pub mod change;
pub mod concern;
pub mod marks;
pub mod replace;
pub mod roll;

use std::collections::BTreeMap;

use serde::Serialize;

pub use self::change::Change;
pub use self::roll::Roll;
pub use super::cache::ROLL;

use self::concern::Concern;
use self::marks::Rows;
use super::intake::Entry;
use super::intake::roster::Person;
use super::policy::mark::Mark;
use super::record::{RecordSummary, TaskSummary};
use super::shared_answers::{self, KnownAnswers, SharedAnswer, SharedPair};
use pinhole_course::outcome::Status;

/// A graded class.
pub struct Class<'a> {
    pub title: String,
    pub roll: &'a Roll,
    /// The rows, in the order of the roll.
    pub rows: Vec<Row<'a>>,
    /// Additional rows, for people whose group handed something in for them.
    pub shared: Vec<Row<'a>>,
    /// What the instructor should look at, the most serious first.
    pub concerns: Vec<Concern>,
    pub alike: Vec<SharedAnswer>,
    /// Pairs that share several answers.
    pub pairs: Vec<SharedPair>,
    records: &'a BTreeMap<String, RecordSummary>,
}

/// A submission's row, for one person.
#[derive(Clone)]
pub struct Row<'a> {
    pub entry: &'a Entry,
    pub person: Option<&'a Person>,
    pub record: Option<&'a RecordSummary>,
    /// The mark; `None` if there is none, or if another submission counts.
    pub mark: Option<Mark>,
    /// Why another submission counts.
    pub not_counted: Option<String>,
    /// Whether another member of the person's group handed it in.
    pub is_shared: bool,
}

/// A belief, and the submissions that seem to hold it.
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
        records: &'a BTreeMap<String, RecordSummary>,
        known: &KnownAnswers,
    ) -> Class<'a> {
        let Rows {
            own,
            shared,
            concerns,
        } = marks::rows(roll, records);
        // Compare only submissions that count, because several attempts by one person are alike
        // anyway.
        let counted = own.iter().filter(|row| row.not_counted.is_none());
        let all: Vec<&RecordSummary> = counted.filter_map(|row| row.record).collect();
        let alike = known.shared_answers(&all);
        let without_numbers = concern::without_numbers(&own).into_iter().collect();
        Class {
            title: title.into(),
            roll,
            pairs: shared_answers::pairs(&alike),
            alike,
            rows: own,
            shared,
            concerns: concern::sorted([roll.concerns(), concerns, without_numbers].concat()),
            records,
        }
    }

    /// Every row: one for each submission, then those of group members.
    pub fn all_rows(&self) -> impl Iterator<Item = &Row<'a>> {
        self.rows.iter().chain(&self.shared)
    }

    /// Everyone's mark, once.
    pub fn gradebook(&self) -> impl Iterator<Item = (&'a Person, &Mark, &Row<'a>)> {
        let rows = self.all_rows();
        rows.filter_map(|row| Some((row.person?, row.mark.as_ref()?, row)))
    }

    /// The records that have a mark.
    pub fn graded(&self) -> impl Iterator<Item = &'a RecordSummary> {
        let records = self.rows.iter().filter_map(|row| row.record);
        records.filter(|record| record.is_graded())
    }

    /// Whether a submission has a mark.
    pub fn is_graded(&self, id: &str) -> bool {
        self.records.get(id).is_some_and(RecordSummary::is_graded)
    }

    /// What the records were judged on, each listed once.
    pub fn judged_on(&self) -> Vec<&'a str> {
        let all = self.graded();
        let mut all: Vec<&str> = all.map(|record| record.judged_on.as_str()).collect();
        all.sort();
        all.dedup();
        all
    }

    /// The submissions without a mark, and why.
    pub fn not_graded(&self) -> Vec<(&'a str, &'a str)> {
        let without = self.rows.iter().filter_map(|row| match row.record {
            Some(record) if record.is_graded() => None,
            Some(record) => Some((row.entry.id.as_str(), record.explanation.as_str())),
            None => Some((
                row.entry.id.as_str(),
                "it has not been graded yet; run `pinhole grade` again",
            )),
        });
        without.collect()
    }

    /// The submissions, by status.
    pub fn outcomes(&self) -> BTreeMap<Status, Vec<&'a str>> {
        let mut outcomes: BTreeMap<Status, Vec<&str>> = BTreeMap::new();
        for row in &self.rows {
            let status = row.record.map_or(Status::NotGraded, |record| record.status);
            outcomes.entry(status).or_default().push(&row.entry.id);
        }
        outcomes
    }

    /// The mistakes in the submissions, the most common first.
    pub fn mistakes(&self) -> Vec<SharedBelief> {
        let mut held: BTreeMap<&str, SharedBelief> = BTreeMap::new();
        for record in self.graded() {
            for TaskSummary { task, mistakes, .. } in &record.tasks {
                for (mistake, belief) in mistakes {
                    let entry = held.entry(mistake).or_insert_with(|| SharedBelief {
                        mistake: mistake.clone(),
                        belief: belief.clone(),
                        tasks: Vec::new(),
                        who: Vec::new(),
                    });
                    if entry.tasks.iter().all(|name| **name != *task.name) {
                        entry.tasks.push(task.name.to_string());
                    }
                    if entry.who.last() != Some(&record.id) {
                        entry.who.push(record.id.clone());
                    }
                }
            }
        }
        let mut held: Vec<SharedBelief> = held.into_values().collect();
        held.sort_by(|a, b| (b.who.len(), &a.mistake).cmp(&(a.who.len(), &b.mistake)));
        held
    }

    /// The slowest submissions, with their times in seconds.
    pub fn slowest(&self) -> Vec<(&'a str, f64)> {
        let times = self
            .graded()
            .map(|record| (record.id.as_str(), record.seconds));
        let mut times: Vec<(&str, f64)> = times.collect();
        times.sort_by(|a, b| b.1.total_cmp(&a.1));
        times.truncate(10);
        times
    }
}
