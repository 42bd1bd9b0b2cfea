//! Writes the files of a class and prints its summary, when grading or merging ends.

use std::collections::BTreeMap;

use serde_json::json;

use super::csv;
use super::formats::Format;
use super::page;
use crate::grade::alike::KnownAnswers;
use crate::grade::cache::ResultCache;
use crate::grade::class::{Change, Class, Roll};
use crate::grade::record::Record;
use pinhole_course::assignment::Assignment;
use pinhole_course::error::Result;
use pinhole_report::escape::printable;

/// What this run alone has done.
#[derive(Default)]
pub struct RunSummary {
    /// How many were graded, not only found valid.
    pub graded: usize,
    pub seconds: f64,
    pub changes: Vec<Change>,
    /// Whose grading failed, and why; an earlier grade of the same may stand.
    pub faults: Vec<(String, String)>,
}

/// Where the results of a class go, and how.
pub struct ClassOutput<'a> {
    pub cache: &'a ResultCache,
    pub assignment: &'a Assignment,
    /// Written beside the files that are always written.
    pub formats: &'a [Format],
    /// Said as a document, not in words.
    pub as_json: bool,
}

impl ClassOutput<'_> {
    /// Writes the class's files and prints its summary; `false` if a mark is missing.
    pub fn write(
        &self,
        roll: &Roll,
        records: &BTreeMap<String, Record>,
        run: &RunSummary,
    ) -> Result<bool> {
        let ClassOutput {
            cache, assignment, ..
        } = self;
        let class = Class::new(
            &assignment.title,
            roll,
            records,
            &KnownAnswers::read(assignment)?,
        );
        for record in records.values() {
            for format in self.formats {
                if let Some((name, content)) = format.of(record)? {
                    cache.write(&format!("submissions/{}/{name}", record.id), &content)?;
                }
            }
        }
        if self.formats.contains(&Format::Csv) {
            cache.write("groups.csv", &csv::groups(&class))?;
        }
        cache.write("grades.csv", &csv::grades(&class, assignment))?;
        cache.write("class.html", &page::html(&class, assignment))?;
        match self.as_json {
            true => anstream::println!("{:#}", document(&class, run)),
            false => anstream::print!("{}", words(&class, run, cache)),
        }
        let not_graded = class.not_graded();
        if not_graded.is_empty() && run.faults.is_empty() {
            return Ok(true);
        }
        anstream::eprintln!(
            "pinhole: {} of {} submissions have no mark, and grading failed for {}\n  remedy: \
             see why above; run the same command again, and it grades these alone",
            not_graded.len(),
            class.rows.len(),
            run.faults.len()
        );
        Ok(false)
    }
}

fn document(class: &Class, run: &RunSummary) -> serde_json::Value {
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
        "graded_now": run.graded,
        "seconds": run.seconds,
        "points": points.collect::<BTreeMap<_, _>>(),
        "outcomes": outcomes,
        "mistakes": class.mistakes(),
        "alike": class.alike,
        "changes": run.changes,
        "faults": run.faults,
        "roster": class.roll.placed,
        "ignored": class.roll.ignored,
    })
}

fn words(class: &Class, run: &RunSummary, cache: &ResultCache) -> String {
    let mut text = String::new();
    let mut line = |words: String| {
        text.push_str(&words);
        text.push('\n');
    };
    for (id, why) in class.not_graded() {
        line(format!("not graded: {}: {}", printable(id), printable(why)));
    }
    let stands = |id: &String| !class.not_graded().iter().any(|(other, _)| other == id);
    for (id, why) in run.faults.iter().filter(|(id, _)| stands(id)) {
        line(format!(
            "not graded again, the old mark stands: {}: {}",
            printable(id),
            printable(why)
        ));
    }
    for change in &run.changes {
        line(format!("changed: {}", printable(&change.in_words())));
    }
    let all = class.rows.len();
    let kept = all.saturating_sub(run.graded);
    let minutes = run.seconds / 60.0;
    line(format!(
        "{all} submissions, {} graded now in {:.0} s ({:.0} a minute), {kept} unchanged",
        run.graded,
        run.seconds,
        run.graded as f64 / minutes.max(1e-9)
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
    line(format!("\ngrades: {}", cache.path("grades.csv").display()));
    line(format!("class:  {}", cache.path("class.html").display()));
    text
}
