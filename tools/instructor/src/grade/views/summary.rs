//! Writes the files of a class and prints its summary, when grading or merging ends.

use std::collections::{BTreeMap, BTreeSet};

use clap::ValueEnum;
use serde_json::json;

use super::csv;
use super::feedback;
use super::formats::Format;
use super::gradebook;
use super::page::{self, Audience};
use super::report;
use crate::grade::cache::{ResultCache, pretty, standing};
use crate::grade::class::concern::{self, Concern};
use crate::grade::class::{Change, Class, Roll};
use crate::grade::record::RecordSummary;
use crate::grade::shared_answers::KnownAnswers;
use pinhole_course::assignment::Assignment;
use pinhole_course::error::Result;
use pinhole_report::escape::printable;
use pinhole_report::program::Status;

/// What this run has done.
#[derive(Default)]
pub struct RunSummary {
    /// How many submissions were graded, not counting those whose result was still valid.
    pub graded: usize,
    pub seconds: f64,
    pub changes: Vec<Change>,
    /// Whether everything was graded again to see what changes.
    pub is_regrade: bool,
    /// The submissions whose grading failed, and why. An earlier grade may still be valid.
    pub faults: Vec<(String, String)>,
}

/// Where and how the results of a class are written.
pub struct ClassOutput<'a> {
    pub cache: &'a ResultCache,
    pub assignment: &'a Assignment,
    /// Formats to write in addition to the files that are always written.
    pub formats: &'a [Format],
    /// Whether to print a JSON document.
    pub as_json: bool,
}

impl ClassOutput<'_> {
    /// Writes the table of marks while others are still graded.
    pub fn write_so_far(
        &self,
        roll: &Roll,
        records: &BTreeMap<String, RecordSummary>,
    ) -> Result<()> {
        let known = KnownAnswers::default();
        let class = Class::new(&self.assignment.title, roll, records, &known);
        let table = csv::grades(&class, self.assignment);
        self.cache.write("grades.csv", table)
    }

    /// Writes the class's files and prints its summary.
    pub fn write(
        &self,
        roll: &Roll,
        records: &BTreeMap<String, RecordSummary>,
        run: &RunSummary,
    ) -> Result<Status> {
        let ClassOutput {
            cache, assignment, ..
        } = self;
        let mut class = Class::new(
            &assignment.title,
            roll,
            records,
            &KnownAnswers::read(assignment)?,
        );
        report::write_marks(&class, cache)?;
        // Remove files of an earlier run that this run does not write, because they are out of
        // date.
        for format in Format::value_variants() {
            let is_asked = self.formats.contains(format);
            for entry in &roll.entries {
                let id = &entry.id;
                let Some(file) = format.file_of_each() else {
                    break;
                };
                let record = is_asked.then(|| standing(&cache.of(id), entry)).flatten();
                let content = record.map(|record| format.of(&record)).transpose()?;
                let name = format!("submissions/{id}/{file}");
                cache.write_or_remove(&name, content.flatten())?;
            }
        }
        let asked = |format: Format| self.formats.contains(&format);
        if asked(Format::Canvas) {
            class.concerns.extend(gradebook::not_on_canvas(&class));
        }
        if asked(Format::Moodle) {
            class.concerns.extend(gradebook::not_on_moodle(&class));
        }
        class.concerns = concern::sorted(class.concerns);
        for (format, name, of) in [
            (
                Format::Csv,
                "groups.csv",
                csv::groups as fn(&Class) -> String,
            ),
            (Format::Canvas, "canvas.csv", gradebook::canvas),
            (Format::Moodle, "moodle.csv", gradebook::moodle),
        ] {
            cache.write_or_remove(name, asked(format).then(|| of(&class)))?;
        }
        let archives = match asked(Format::Feedback) {
            true => feedback::archives(&class, cache)?,
            false => feedback::NAMES.map(|name| (name, None)),
        };
        for (name, archive) in archives {
            cache.write_or_remove(name, archive)?;
        }
        let changes = run.is_regrade.then(|| csv::changes(&run.changes));
        cache.write_or_remove("changes.csv", changes)?;
        cache.write("grades.csv", csv::grades(&class, assignment))?;
        for (name, audience) in [
            ("class.html", Audience::Instructor),
            ("class_without_names.html", Audience::Class),
        ] {
            cache.write(name, page::html(&class, assignment, audience))?;
        }
        match self.as_json {
            true => anstream::print!("{}", pretty(&document(&class, run))?),
            false => anstream::print!("{}", words(&class, run, cache)),
        }
        let failed: BTreeSet<&String> = run.faults.iter().map(|(id, _)| id).collect();
        for (id, record) in records {
            if record.is_graded() && !failed.contains(id) {
                cache.forget_listed(id);
            }
        }
        let not_graded = class.not_graded();
        if not_graded.is_empty() && run.faults.is_empty() {
            return Ok(status(&class.concerns));
        }
        anstream::eprintln!(
            "pinhole: submissions without a mark: {} of {}; grading failed in this run: {}\n  \
             remedy: see the reasons above; if you run `pinhole grade` again, it grades only these",
            not_graded.len(),
            class.rows.len(),
            run.faults.len()
        );
        Ok(Status::Incomplete)
    }
}

fn document(class: &Class, run: &RunSummary) -> serde_json::Value {
    let outcomes = class.outcomes().into_iter();
    let outcomes: BTreeMap<&str, Vec<&str>> =
        outcomes.map(|(kind, who)| (kind.word(), who)).collect();
    let points = class.rows.iter().map(|row| {
        let points = row.record.and_then(|record| record.points);
        (row.entry.id.as_str(), points)
    });
    json!({
        "assignment": class.title,
        "submissions": class.rows.len(),
        "not_graded": class.not_graded(),
        "judged_on": class.judged_on(),
        "graded_now": run.graded,
        "seconds": run.seconds,
        "points": points.collect::<BTreeMap<_, _>>(),
        "outcomes": outcomes,
        "mistakes": class.mistakes(),
        "alike": class.alike,
        "pairs": class.pairs,
        "changes": run.changes,
        "faults": run.faults,
        "summary": class.roll.headline(&|id| class.is_graded(id), "graded"),
        "concerns": class.concerns,
        "marks": class.all_rows().filter(|row| row.mark.is_some()).map(|row| json!({
            "id": row.person.map(|person| &person.id),
            "submission": row.entry.id,
            "mark": row.mark,
        })).collect::<Vec<_>>(),
        "roster": class.roll.placed,
        "ignored": class.roll.ignored,
    })
}

/// Whether anyone may have lost points because of how files were handed in.
pub fn status(concerns: &[Concern]) -> Status {
    match concerns.iter().any(|concern| concern.is_grave) {
        true => Status::JudgedWrong,
        false => Status::Well,
    }
}

/// How many people are graded, and what the instructor should look at before marks go out.
pub fn attention(concerns: &[Concern], headline: String) -> String {
    let mut text = format!("{headline}\n");
    for Concern {
        what,
        which,
        is_grave,
    } in concerns
    {
        let mark = if *is_grave { "! " } else { "  " };
        text.push_str(&format!("{mark}{} {what}\n", which.len()));
        for one in which {
            text.push_str(&format!("      {}\n", printable(one)));
        }
    }
    text
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
            "not graded again; the old mark remains: {}: {}",
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
    let word = if all == 1 {
        "submission"
    } else {
        "submissions"
    };
    line(format!(
        "{all} {word}, {} graded now in {:.0} s ({:.0} a minute), {kept} unchanged",
        run.graded,
        run.seconds,
        run.graded as f64 / minutes.max(1e-9)
    ));
    for (kind, who) in class.outcomes() {
        line(format!("{:>5} {}", who.len(), kind.word()));
    }
    if !class.alike.is_empty() {
        let groups = class.alike.len();
        let word = if groups == 1 { "group" } else { "groups" };
        line(format!("{groups:>5} {word} of equal answers"));
    }
    line(String::new());
    for judged_on in class.judged_on() {
        text.push_str(&format!("judged on {judged_on}\n"));
    }
    let headline = class.roll.headline(&|id| class.is_graded(id), "graded");
    text.push_str(&attention(&class.concerns, headline));
    let mut line = |words: String| {
        text.push_str(&words);
        text.push('\n');
    };
    let shown = |name| printable(&cache.path(name).display().to_string());
    line(format!("\ngrades: {}", shown("grades.csv")));
    line(format!("class:  {}", shown("class.html")));
    text
}
