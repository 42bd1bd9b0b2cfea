//! Prints what `grade --dry-run` shows: who handed in each submission, and what was found in it.

use std::collections::BTreeMap;

use serde_json::json;

use super::summary::{attention, status};
use crate::grade::cache::pretty;
use crate::grade::class::{Roll, concern, marks};
use pinhole_course::assignment::Assignment;
use pinhole_course::error::Result;
use pinhole_report::escape::printable;
use pinhole_report::program::Status;

/// Prints everything that is known before anything is judged.
pub fn print(roll: &Roll, assignment: &Assignment, as_json: bool) -> Result<Status> {
    let can_be_graded = |id: &str| {
        let mut entries = roll.entries.iter();
        entries.any(|entry| entry.id == id && entry.submission.is_ok())
    };
    let nothing_graded = BTreeMap::new();
    let by_policy = marks::rows(roll, &nothing_graded).concerns;
    let concerns = concern::sorted([roll.concerns(), by_policy].concat());
    let headline = roll.headline(&can_be_graded, "ready to be graded");
    if as_json {
        let document = json!({
            "assignment": assignment.title,
            "submissions": roll.entries,
            "summary": headline,
            "concerns": concerns,
            "roster": roll.placed,
            "ignored": roll.ignored,
        });
        anstream::print!("{}", pretty(&document)?);
        return Ok(status(&concerns));
    }
    for entry in &roll.entries {
        let person = match (roll.placed.of.get(&entry.id), roll.placed.people) {
            (Some(person), _) => format!("{} [{}]", person.name, person.id),
            (None, Some(_)) => "?".into(),
            (None, None) => "no roster".into(),
        };
        let found = match &entry.submission {
            Ok(submission) => {
                let usable = submission.answers.iter().filter(|it| it.text.is_ok());
                let of = assignment.tasks.len();
                format!("{} of {of} answer files", usable.count())
            }
            Err(why) => format!("cannot be graded: {why}"),
        };
        let line = format!("{}: {person}: {found}", entry.id);
        anstream::println!("{}", printable(&line));
    }
    anstream::print!("\n{}", attention(&concerns, headline));
    Ok(status(&concerns))
}
