//! What a run set out to grade, kept until it has: a run that is stopped leaves grades of
//! older answers behind, and a merge must not take them for new ones.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use super::intake::{self, Entry};
use super::provenance::{MadeWith, Provenance};
use super::record::Record;
use super::store::{Store, pretty};
use pinhole_course::assignment::Assignment;
use pinhole_course::error::{Error, Result};

/// By submission: the answers that its grade is to be of. (By what they are judged, all
/// parts must agree; a merge checks that itself.)
#[derive(Debug, Default)]
pub struct Unfinished(BTreeMap<String, Hashes>);

/// As [`Provenance::answers`].
type Hashes = Vec<(String, String)>;

/// The file, in the folder of a graded class.
const FILE: &str = "unfinished.json";

impl Unfinished {
    /// Writes down all submissions whose grade is missing or of other answers.
    pub fn begin(
        entries: &[Entry],
        store: &Store,
        assignment: &Assignment,
        made_with: &MadeWith,
    ) -> Result<()> {
        let mut unfinished = BTreeMap::new();
        for entry in entries {
            // What cannot be opened has no answers; its record tells why.
            let Ok(submission) = intake::open(entry, assignment) else {
                continue;
            };
            let wanted = Provenance::of(&submission, made_with).answers;
            let is_of_these = |record: Record| record.provenance.answers == wanted;
            if !store.record(&entry.id).is_some_and(is_of_these) {
                unfinished.insert(entry.id.clone(), wanted);
            }
        }
        store.write(FILE, &pretty(&unfinished)?)
    }

    /// All is graded.
    pub fn end(store: &Store) {
        let _was_never_there = fs::remove_file(store.path(FILE));
    }

    /// What the last run in a folder left undone; nothing, if it came to its end.
    pub fn read(folder: &Path) -> Result<Unfinished> {
        let path = folder.join(FILE);
        let Ok(text) = fs::read_to_string(&path) else {
            return Ok(Unfinished::default());
        };
        serde_json::from_str(&text)
            .map(Unfinished)
            .map_err(|error| {
                let problem = format!("{}: {error}", path.display());
                Error::input(problem, "grade that shard again with this version")
            })
    }

    /// The record, if it is of what was to be graded; else, that it is not graded.
    pub fn check(&self, record: Record) -> Record {
        match self.0.get(&record.id) {
            Some(wanted) if *wanted != record.provenance.answers => record.not_graded(
                "the run was stopped before it came to these answers; an older mark is of others"
                    .into(),
            ),
            _ => record,
        }
    }
}
