//! Parses the names that learning platforms give to submissions, and the names of answer
//! files.
//!
//! Canvas: `lastfirst_USER_FILE_name.zip` or `lastfirst_LATE_USER_FILE_name.zip`; a later
//! upload has a greater FILE. Moodle: `First Last_NUMBER_assignsubmission_file`, a folder with
//! what was handed in or the beginning of a file's name. The uploader chooses what follows.

use jiff::civil::DateTime;
use serde::{Deserialize, Serialize};

use pinhole_course::assignment::{Assignment, Task};

/// What the name of an upload tells about the person.
#[derive(Clone, Debug, Deserialize, Eq, Ord, PartialEq, PartialOrd, Serialize)]
pub struct Sign {
    /// A person's name, or an id.
    pub person: String,
    /// The platform's number for the person.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub number: Option<String>,
}

/// A name given by a platform.
#[derive(Clone, Debug, PartialEq)]
pub struct PlatformName<'a> {
    pub person: &'a str,
    pub number: &'a str,
    /// Greater for later uploads, where the platform counts them.
    pub upload: u64,
    /// What the uploader called it.
    pub rest: &'a str,
}

impl PlatformName<'_> {
    pub fn sign(&self) -> Sign {
        Sign {
            person: self.person.into(),
            number: Some(self.number.into()),
        }
    }

    /// Reads a name as Canvas writes it, if it may be one.
    pub fn canvas(name: &str) -> Option<PlatformName<'_>> {
        let (person, rest) = name.split_once('_')?;
        let (mut number, mut rest) = rest.split_once('_')?;
        if number.eq_ignore_ascii_case("late") {
            (number, rest) = rest.split_once('_')?;
        }
        let (file, rest) = rest.split_once('_')?;
        let is_name = !person.is_empty() && is_number(number) && !rest.is_empty();
        is_name.then_some(PlatformName {
            person,
            number,
            upload: file.parse().ok()?,
            rest,
        })
    }

    /// Reads a name as Moodle writes it, if it may be one.
    pub fn moodle(name: &str) -> Option<PlatformName<'_>> {
        let (before, rest) = name.split_once("_assignsubmission_")?;
        let (person, number) = before.rsplit_once('_')?;
        let (_, rest) = rest.split_once('_').unwrap_or((rest, ""));
        is_number(number).then_some(PlatformName {
            person,
            number,
            upload: 0,
            rest,
        })
    }
}

fn is_number(text: &str) -> bool {
    text.parse::<u64>().is_ok()
}

/// All ways to read a name as a platform's. An uploader can make it look like the names of two
/// platforms; then it is unknown which it is.
pub fn platforms(name: &str) -> Vec<PlatformName<'_>> {
    [PlatformName::canvas(name), PlatformName::moodle(name)]
        .into_iter()
        .flatten()
        .collect()
}

/// When something was handed in, according to the names.
#[derive(Clone, Copy, Debug, Eq, Ord, PartialEq, PartialOrd)]
pub enum HandInTime<Time> {
    At(Time),
    /// Some time after the platform's deadline.
    Late,
}

/// When these files were handed in, according to their names. The last time counts, and one late
/// file makes all late. Canvas marks late files with `LATE`. Blackboard
/// (`…_attempt_2026-11-20-23-59-01_…`) and Brightspace (`… - Nov 20, 2026 1159 PM - …`) write the
/// time before the name that the uploader chose.
pub fn handed_in(given: &[String]) -> Option<HandInTime<DateTime>> {
    given.iter().filter_map(|name| time_in(name)).max()
}

fn time_in(name: &str) -> Option<HandInTime<DateTime>> {
    let is_canvas = PlatformName::canvas(name).is_some();
    if is_canvas && name.split('_').nth(1)?.eq_ignore_ascii_case("late") {
        return Some(HandInTime::Late);
    }
    if let Some((_, rest)) = name.split_once("_attempt_") {
        let time = rest.get(..19)?;
        let time = DateTime::strptime("%Y-%m-%d-%H-%M-%S", time).ok()?;
        return Some(HandInTime::At(time));
    }
    let parts = name.split(" - ");
    let mut times = parts.filter_map(|part| DateTime::strptime("%b %d, %Y %I%M %p", part).ok());
    times.next().map(HandInTime::At)
}

/// The task that a file of this name may answer, and whether the name is exactly the one that
/// was handed out. Recognises names that people or programs have changed: `Sphere.rs`, `sphere
/// (1).rs`, `sphere-2.rs`, `sphere.rs.txt`.
pub fn task_of<'a>(name: &str, assignment: &'a Assignment) -> Option<(&'a Task, bool)> {
    let exact = assignment.tasks.iter().find(|task| task.file() == name);
    if let Some(task) = exact {
        return Some((task, true));
    }
    let plain = plain_stem(name)?;
    let mut tasks = assignment.tasks.iter();
    let task = tasks.find(|task| task.name.replace('_', "").to_lowercase() == plain)?;
    Some((task, false))
}

/// A source file's name without its end, in small letters, without spaces and what marks a
/// copy.
fn plain_stem(name: &str) -> Option<String> {
    let lower = name.trim().to_lowercase();
    let lower = lower.strip_suffix(".txt").unwrap_or(&lower);
    let mut stem = lower.strip_suffix(".rs")?.trim();
    stem = stem.strip_prefix("copy of ").unwrap_or(stem);
    loop {
        let shorter = without_count(stem);
        let shorter = shorter.strip_suffix("copy").unwrap_or(shorter);
        let shorter = shorter.trim_end_matches([' ', '-', '_']);
        if shorter == stem {
            break;
        }
        stem = shorter;
    }
    Some(stem.replace([' ', '-', '_'], ""))
}

/// A name without `(2)` or `-2` at its end.
fn without_count(stem: &str) -> &str {
    let is_count = |text: &str| !text.is_empty() && text.chars().all(|c| c.is_ascii_digit());
    let in_brackets = stem
        .strip_suffix(')')
        .and_then(|stem| stem.rsplit_once('('));
    match in_brackets.or(stem.rsplit_once('-')) {
        Some((shorter, count)) if is_count(count) => shorter,
        _ => stem,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_that_programs_and_people_change_still_name_their_task() {
        for name in [
            "Triangle_Soup.rs",
            "triangle_soup.RS",
            "triangle_soup (1).rs",
            "triangle_soup(12).rs",
            "triangle_soup-1.rs",
            "triangle_soup - Copy.rs",
            "triangle_soup - Copy (2).rs",
            "Copy of triangle_soup.rs",
            "triangle soup copy.rs",
            "TriangleSoup.rs",
            "triangle_soup.rs.txt",
        ] {
            assert_eq!(plain_stem(name).as_deref(), Some("trianglesoup"), "{name}");
        }
        for name in [
            "triangle_soup.rs~",
            "triangle_soup2.rs",
            "soup.rs",
            "triangle_soup.c",
        ] {
            assert_ne!(plain_stem(name).as_deref(), Some("trianglesoup"), "{name}");
        }
    }

    #[test]
    fn names_say_when_something_was_handed_in() {
        let of = |names: &[&str]| {
            let names: Vec<String> = names.iter().map(|name| (*name).to_owned()).collect();
            match handed_in(&names) {
                Some(HandInTime::At(time)) => time.to_string(),
                Some(HandInTime::Late) => "late".into(),
                None => "unknown".into(),
            }
        };
        for (names, said) in [
            (
                &["HW1_al1_attempt_2026-11-20-23-59-01_hw_attempt_2020-01-01-00-00-00.zip"][..],
                "2026-11-20T23:59:01",
            ),
            (
                &["11-22 - Ada Lovelace - Nov 21, 2026 1207 AM - hw1.zip"],
                "2026-11-21T00:07:00",
            ),
            (&["lovelaceada_LATE_11_501_hw1.zip"], "late"),
            (
                &[
                    "lovelaceada_11_501_sphere.rs",
                    "lovelaceada_LATE_11_502_plane.rs",
                ],
                "late",
            ),
            (&["lovelaceada_11_501_hw1_LATE.zip"], "unknown"),
            (&["ada"], "unknown"),
        ] {
            assert_eq!(of(names), said, "{names:?}");
        }
    }

    #[test]
    fn a_platforms_part_of_a_name_is_separated_from_the_uploaders() {
        let canvas = |name| PlatformName::canvas(name).map(|it| (it.person, it.number, it.upload));
        let ada = Some(("lovelaceada", "12", 501));
        assert_eq!(canvas("lovelaceada_12_501_answers.zip"), ada);
        assert_eq!(canvas("lovelaceada_LATE_12_501_sphere-1.rs"), ada);
        assert_eq!(canvas("homework_2"), None);
        let moodle = PlatformName::moodle("Ada Lovelace_2001_assignsubmission_file_");
        assert_eq!(
            moodle.map(|it| (it.person, it.number)),
            Some(("Ada Lovelace", "2001"))
        );
        let flat = PlatformName::moodle("Ada Lovelace_2001_assignsubmission_file_hw1.zip");
        assert_eq!(flat.map(|it| it.rest), Some("hw1.zip"));
        let both = platforms("malletmallory_13_503_x_20231234_assignsubmission_file.zip");
        assert_eq!(both.len(), 2);
    }
}
