//! Results of earlier runs. Those that are still valid are not graded again; at most, their points
//! are computed again.

use std::collections::BTreeMap;

use rayon::prelude::*;

use super::cache::{ResultCache, standing};
use super::class::{Change, Roll};
use super::intake::Entry;
use super::points;
use super::provenance::{GradingInputs, Provenance};
use super::queue::QueueResult;
use super::record::Record;
use pinhole_course::assignment::Assignment;
use pinhole_course::error::Result;

/// The results in a class's folder, and what this run grades with.
pub struct StoredResults<'a> {
    pub cache: &'a ResultCache,
    pub made_with: &'a GradingInputs,
    pub assignment: &'a Assignment,
}

/// Why a submission is graded again; `None` if it has no result.
type Regrading = Option<&'static str>;

impl StoredResults<'_> {
    /// The results that are still valid, and the submissions that have none. Prints why results are
    /// no longer valid.
    pub fn valid(&self, entries: &[Entry]) -> Result<(Vec<QueueResult>, Vec<Entry>)> {
        let found: Vec<_> = entries.par_iter().map(|entry| self.of(entry)).collect();
        let mut valid = Vec::new();
        let mut to_grade = Vec::new();
        let mut again: BTreeMap<&str, usize> = BTreeMap::new();
        for (entry, found) in entries.iter().zip(found) {
            match found? {
                Ok(result) => valid.push(result),
                Err(why) => {
                    to_grade.push(entry.clone());
                    if let Some(why) = why {
                        *again.entry(why).or_default() += 1;
                    }
                }
            }
        }
        for (why, count) in again {
            anstream::eprintln!("to be graded again: {count} (last graded with {why})");
        }
        Ok((valid, to_grade))
    }

    /// The results of submissions of the class that this run does not read, because only `mine` were
    /// passed.
    pub fn of_others(&self, class: &Roll, mine: &[Entry]) -> Result<Vec<QueueResult>> {
        let is_mine = |id: &str| mine.iter().any(|entry| entry.id == id);
        let others = class.entries.iter().filter(|entry| !is_mine(&entry.id));
        let stored = others.filter_map(|entry| standing(&self.cache.of(&entry.id), entry));
        stored
            .map(|record| {
                let is_old = !record.provenance.made_with.asks_the_same(self.made_with);
                kept(record, self.cache, self.assignment, is_old)
            })
            .collect()
    }

    /// The stored result of a submission if it is still valid, with the current points of its
    /// parts. Otherwise, why not.
    fn of(&self, entry: &Entry) -> Result<std::result::Result<QueueResult, Regrading>> {
        let (Some(before), Ok(submission)) = (self.cache.get(&entry.id), &entry.submission) else {
            return Ok(Err(None));
        };
        let provenance = Provenance::of(submission, self.made_with);
        if let Some(change) = provenance.change_since(&before.provenance) {
            return Ok(Err(Some(change)));
        }
        if before.got.submission != entry.name || before.remarks != entry.remarks() {
            return Ok(Err(Some("other file names")));
        }
        self.cache.forget_fault(&entry.id);
        with_current_points(before, self.cache, self.assignment).map(Ok)
    }
}

/// The stored result of a submission, with the current points of its parts.
fn with_current_points(
    before: Record,
    cache: &ResultCache,
    assignment: &Assignment,
) -> Result<QueueResult> {
    let mut record = before.clone();
    points::compute(&mut record, assignment);
    if record != before {
        cache.put_points(&record)?;
    }
    Ok(QueueResult {
        change: Change::between(
            cache.listed(&record.id).as_ref().unwrap_or(&before),
            &record,
        ),
        record: record.into(),
        is_new: false,
        fault: None,
    })
}

/// Like [`with_current_points`], but for a submission whose answers this run has not read. If
/// `is_old`, it was asked other questions than this run asks. Then it keeps its points, and its fault
/// says so.
pub fn kept(
    before: Record,
    cache: &ResultCache,
    assignment: &Assignment,
    is_old: bool,
) -> Result<QueueResult> {
    let is_old = before.is_graded() && is_old;
    if before.is_graded() && !is_old {
        return with_current_points(before, cache, assignment);
    }
    let why = "it was graded with other questions or goldens; grade the whole class again";
    Ok(QueueResult {
        fault: is_old.then(|| (before.id.clone(), why.into())),
        record: before.into(),
        is_new: false,
        change: None,
    })
}
