//! What is written and said of a class when its grading, or its merging, ends.

use std::collections::BTreeMap;

use serde_json::json;

use super::alike::Known;
use super::changes::Change;
use super::class::{Class, Roll};
use super::csv;
use super::formats::Format;
use super::page;
use super::record::Record;
use super::store::Store;
use pinhole_course::assignment::Assignment;
use pinhole_course::error::Result;
use pinhole_course::escape::printable;

/// What is said of this run alone.
#[derive(Default)]
pub struct Told {
    pub anew: usize,
    pub seconds: f64,
    pub changes: Vec<Change>,
    /// Whose grading failed, and why; an earlier grade of the same may stand.
    pub faults: Vec<(String, String)>,
}

/// Where a class is told of, and how.
pub struct Telling<'a> {
    pub store: &'a Store,
    pub assignment: &'a Assignment,
    /// Written beside the files that are always written.
    pub formats: &'a [Format],
    /// Said as a document, not in words.
    pub as_json: bool,
}

impl Telling<'_> {
    /// Writes what is said of the class, and says it; `false` if a mark is missing.
    pub fn finish(
        &self,
        roll: &Roll,
        records: &BTreeMap<String, Record>,
        told: &Told,
    ) -> Result<bool> {
        let Telling {
            store, assignment, ..
        } = self;
        let class = Class::new(&assignment.title, roll, records, &Known::read(assignment)?);
        for record in records.values() {
            for format in self.formats {
                if let Some((name, content)) = format.of(record)? {
                    store.write(&format!("submissions/{}/{name}", record.id), &content)?;
                }
            }
        }
        if self.formats.contains(&Format::Csv) {
            store.write("groups.csv", &csv::groups(&class))?;
        }
        store.write("grades.csv", &csv::grades(&class, assignment))?;
        store.write("class.html", &page::html(&class, assignment))?;
        match self.as_json {
            true => anstream::println!("{:#}", document(&class, told)),
            false => anstream::print!("{}", words(&class, told, store)),
        }
        let not_graded = class.not_graded();
        if not_graded.is_empty() && told.faults.is_empty() {
            return Ok(true);
        }
        anstream::eprintln!(
            "pinhole: {} of {} submissions have no mark, and grading failed for {}\n  remedy: \
             see why above; run the same command again, and it grades these alone",
            not_graded.len(),
            class.rows.len(),
            told.faults.len()
        );
        Ok(false)
    }
}

fn document(class: &Class, told: &Told) -> serde_json::Value {
    let outcomes = class.outcomes().into_iter();
    let outcomes: BTreeMap<&str, Vec<&str>> =
        outcomes.map(|(kind, who)| (kind.word(), who)).collect();
    let points = class.rows.iter().map(|row| {
        let points = row.record.and_then(|record| record.got.points);
        (row.entry.id.as_str(), points)
    });
    json!({
        "assignment": class.title,
        "submissions": class.rows.len(),
        "not_graded": class.not_graded(),
        "graded_now": told.anew,
        "seconds": told.seconds,
        "points": points.collect::<BTreeMap<_, _>>(),
        "outcomes": outcomes,
        "mistakes": class.mistakes(),
        "alike": class.alike,
        "changes": told.changes,
        "faults": told.faults,
        "roster": class.roll.placed,
        "ignored": class.roll.ignored,
    })
}

fn words(class: &Class, told: &Told, store: &Store) -> String {
    let mut text = String::new();
    let mut line = |words: String| {
        text.push_str(&words);
        text.push('\n');
    };
    for (id, why) in class.not_graded() {
        line(format!("not graded: {}: {}", printable(id), printable(why)));
    }
    let stands = |id: &String| !class.not_graded().iter().any(|(other, _)| other == id);
    for (id, why) in told.faults.iter().filter(|(id, _)| stands(id)) {
        line(format!(
            "not graded again, the old mark stands: {}: {}",
            printable(id),
            printable(why)
        ));
    }
    for change in &told.changes {
        line(format!("changed: {}", printable(&change.in_words())));
    }
    let all = class.rows.len();
    let kept = all.saturating_sub(told.anew);
    let minutes = told.seconds / 60.0;
    line(format!(
        "{all} submissions, {} graded now in {:.0} s ({:.0} a minute), {kept} unchanged",
        told.anew,
        told.seconds,
        told.anew as f64 / minutes.max(1e-9)
    ));
    for (kind, who) in class.outcomes() {
        line(format!("{:>5} {}", who.len(), kind.word()));
    }
    let placed = &class.roll.placed;
    let lists = [
        ("nothing handed in", placed.missing.len()),
        ("on no roster", placed.unknown.len()),
        ("could be several people's", placed.ambiguous.len()),
        ("earlier attempts, not graded", placed.superseded.len()),
        ("people with several submissions", placed.several.len()),
        ("answers the same as others", class.alike.len()),
    ];
    for (what, count) in lists.into_iter().filter(|(_, count)| *count > 0) {
        line(format!("{count:>5} {what}"));
    }
    line(format!("\ngrades: {}", store.path("grades.csv").display()));
    line(format!("class:  {}", store.path("class.html").display()));
    text
}
