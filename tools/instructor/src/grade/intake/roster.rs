//! Whose submission it is: the roster of a course, and the names that learning
//! platforms give to what they export.
//!
//! Canvas: `lastfirst_USER_FILE_name.zip` or `lastfirst_LATE_USER_FILE_name.zip`, where a
//! later attempt has a greater FILE and, within it, a greater `-N` at the end of its
//! name. Moodle: `First Last_NUMBER_assignsubmission_file`, one for each person.
//! Anything else is the name of its folder, and has no order of attempts.

use std::collections::BTreeMap;
use std::path::Path;

use serde::{Deserialize, Serialize};

use super::Entry;
use pinhole_course::error::{Error, Result, ResultExt};

/// Somebody on the roster.
#[derive(Clone, Debug, Default, Deserialize, PartialEq, Serialize)]
pub struct Person {
    pub id: String,
    pub name: String,
    #[serde(default)]
    pub section: String,
}

/// Which submission is whose, and which could not be placed.
#[derive(Clone, Debug, Default, Deserialize, PartialEq, Serialize)]
pub struct Placement {
    /// By the submission's id.
    pub of: BTreeMap<String, Person>,
    /// People without a submission.
    pub missing: Vec<Person>,
    /// Submissions by people who are not on the roster. They are graded.
    pub unknown: Vec<String>,
    /// Submissions that several people may have made, and who these are. They are graded.
    pub ambiguous: BTreeMap<String, Vec<Person>>,
    /// Earlier attempts that are not graded, and the later one that is.
    pub superseded: BTreeMap<String, String>,
    /// People with several submissions whose names tell no order. All are graded.
    pub several: BTreeMap<String, Vec<String>>,
}

/// The people of a course, in the file's order.
pub fn read(path: &Path) -> Result<Vec<Person>> {
    let wrong = Error::input(
        path.display().to_string(),
        "a roster is a CSV file with a first line: id,name,section",
    );
    let bytes = std::fs::read(path).or_fail(&wrong)?;
    // Spreadsheets begin their files with a mark.
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(&bytes);
    let mut reader = csv::ReaderBuilder::new()
        .trim(csv::Trim::All)
        .from_reader(bytes);
    let headers = reader.headers().or_fail(&wrong)?.clone();
    let lower: csv::StringRecord = headers.iter().map(str::to_lowercase).collect();
    reader.set_headers(lower);
    let people: std::result::Result<Vec<Person>, csv::Error> = reader.deserialize().collect();
    let people = people.or_fail(&wrong)?;
    let mut ids: Vec<&str> = people.iter().map(|person| person.id.as_str()).collect();
    ids.sort();
    match ids.windows(2).find(|pair| pair[0] == pair[1]) {
        Some(pair) => Err(wrong.because(format!("two people have the id {}", pair[0]))),
        None => Ok(people),
    }
}

/// What a submission's name says.
#[derive(Clone, Debug, PartialEq)]
struct SubmissionName {
    /// A person's name, or an id.
    person: String,
    /// The platform's number for the person.
    number: Option<String>,
    /// Later attempts are greater.
    attempt: Option<(u64, u64)>,
}

impl SubmissionName {
    fn by(name: &str) -> SubmissionName {
        let stem = name.strip_suffix(".zip").unwrap_or(name);
        SubmissionName::by_moodle(stem)
            .or_else(|| SubmissionName::by_canvas(stem))
            .unwrap_or(SubmissionName {
                person: stem.into(),
                number: None,
                attempt: None,
            })
    }

    fn by_moodle(stem: &str) -> Option<SubmissionName> {
        let (before, _) = stem.split_once("_assignsubmission_")?;
        let (person, number) = before.rsplit_once('_')?;
        number.parse::<u64>().ok()?;
        Some(SubmissionName {
            person: person.into(),
            number: Some(number.into()),
            attempt: None,
        })
    }

    fn by_canvas(stem: &str) -> Option<SubmissionName> {
        let mut parts = stem.splitn(5, '_');
        let person = parts.next()?;
        let mut number = parts.next()?;
        if number.eq_ignore_ascii_case("late") {
            number = parts.next()?;
        }
        number.parse::<u64>().ok()?;
        let file = parts.next()?.parse().ok()?;
        // Without a file's name it is some folder that ends in numbers.
        let name = parts.next()?;
        let again = name
            .rsplit_once('-')
            .and_then(|(_, count)| count.parse().ok());
        Some(SubmissionName {
            person: person.into(),
            number: Some(number.into()),
            attempt: Some((file, again.unwrap_or(0))),
        })
    }
}

/// Letters and digits, in small letters.
fn folded(text: &str) -> String {
    let kept = text.chars().filter(|c| c.is_alphanumeric());
    kept.flat_map(char::to_lowercase).collect()
}

/// The ways a person's name may be run together, the last name first or last.
fn names(person: &Person) -> Vec<String> {
    let words: Vec<String> = person
        .name
        .split(|c: char| c.is_whitespace() || c == ',')
        .map(folded)
        .filter(|word| !word.is_empty())
        .collect();
    let turned = |k: usize| [&words[k..], &words[..k]].concat().concat();
    let all: Vec<String> = (0..words.len()).map(turned).collect();
    // Platforms drop letters that are not ASCII, or keep them.
    let ascii = all
        .iter()
        .map(|name| name.chars().filter(char::is_ascii).collect());
    let ascii: Vec<String> = ascii.collect();
    [all, ascii].concat()
}

/// The people who may have handed in a submission of this name: those who match its most
/// reliable part.
fn candidates<'a>(said: &SubmissionName, people: &'a [Person]) -> Vec<&'a Person> {
    let is = |sign: &dyn Fn(&Person) -> bool| -> Vec<&'a Person> {
        people.iter().filter(|person| sign(person)).collect()
    };
    let person = folded(&said.person);
    let words: Vec<String> = said
        .person
        .split(|c: char| !c.is_alphanumeric())
        .map(folded)
        .collect();
    let by_id = is(&|other| folded(&other.id) == person);
    let by_number = is(&|other| said.number.as_ref() == Some(&other.id));
    let by_name = is(&|other| names(other).contains(&person));
    let by_word = is(&|other| !other.id.is_empty() && words.contains(&folded(&other.id)));
    [by_id, by_number, by_name, by_word]
        .into_iter()
        .find(|found| !found.is_empty())
        .unwrap_or_default()
}

/// Says whose each submission is. Without a roster, only attempts are told apart.
pub fn place(entries: &[Entry], people: Option<&[Person]>) -> Placement {
    let mut placed = Placement::default();
    let mut attempts: BTreeMap<String, Vec<(&Entry, SubmissionName)>> = BTreeMap::new();
    for entry in entries {
        let said = SubmissionName::by(&entry.name);
        let found = people.map(|people| candidates(&said, people));
        let key = match found.as_deref() {
            Some([person]) => {
                placed.of.insert(entry.id.clone(), (*person).clone());
                format!("roster {}", person.id)
            }
            Some([]) => {
                placed.unknown.push(entry.id.clone());
                unplaced(entry, &said)
            }
            Some(several) => {
                let several = several.iter().map(|person| (*person).clone()).collect();
                placed.ambiguous.insert(entry.id.clone(), several);
                unplaced(entry, &said)
            }
            None => unplaced(entry, &said),
        };
        attempts.entry(key).or_default().push((entry, said));
    }
    for (_, mut of_one) in attempts {
        if of_one.len() < 2 {
            continue;
        }
        of_one.sort_by_key(|(_, b)| std::cmp::Reverse(b.attempt));
        let ordered = of_one.iter().all(|(_, said)| said.attempt.is_some())
            && of_one
                .windows(2)
                .all(|pair| pair[0].1.attempt != pair[1].1.attempt);
        let mut ids = of_one.iter().map(|(entry, _)| entry.id.clone());
        let newest = ids.next().unwrap_or_default();
        if ordered {
            placed.superseded.extend(ids.map(|id| (id, newest.clone())));
        } else {
            let mut all: Vec<String> = std::iter::once(newest.clone()).chain(ids).collect();
            all.sort();
            placed.several.insert(all[0].clone(), all);
        }
    }
    let handed_in = |person: &Person| placed.of.values().any(|other| other.id == person.id);
    let missing = people
        .unwrap_or_default()
        .iter()
        .filter(|person| !handed_in(person));
    placed.missing = missing.cloned().collect();
    placed
}

/// Attempts of a person who is not on the roster belong together if the platform numbers
/// people.
fn unplaced(entry: &Entry, said: &SubmissionName) -> String {
    match (&said.number, said.attempt) {
        (Some(number), Some(_)) => format!("canvas {number}"),
        _ => format!("entry {}", entry.id),
    }
}

#[cfg(test)]
mod tests {
    use std::path::PathBuf;

    use super::*;

    fn entries(names: &[&str]) -> Vec<Entry> {
        let entry = |name: &&str| Entry {
            id: (*name).into(),
            name: (*name).into(),
            path: PathBuf::new(),
        };
        names.iter().map(entry).collect()
    }

    fn people() -> Vec<Person> {
        let person = |(id, name): (&str, &str)| Person {
            id: id.into(),
            name: name.into(),
            section: String::new(),
        };
        [
            ("s1", "Ada Lovelace"),
            ("s2", "Hopper, Grace"),
            ("s3", "Zoë Müller"),
            ("s4", "Sam Lee"),
            ("s5", "Lee Sam"),
        ]
        .map(person)
        .into()
    }

    #[track_caller]
    fn is(name: &str, id: &str) {
        let placed = place(&entries(&[name]), Some(&people()));
        let found = placed.of.get(name).map(|person| person.id.as_str());
        assert_eq!(found, Some(id), "{name}: {placed:?}");
    }

    #[test]
    fn names_of_canvas_and_moodle_and_plain_ones_find_their_people() {
        is("lovelaceada_12345_67890_answers.zip", "s1");
        is("hoppergrace_LATE_12345_67890_src-2.zip", "s2");
        is("mllerzo_1_2_a.zip", "s3");
        is("müllerzoë_1_2_a.zip", "s3");
        is("Grace Hopper_777_assignsubmission_file", "s2");
        is("Ada Lovelace_777_assignsubmission_file_", "s1");
        is("s1", "s1");
        is("homework_s2", "s2");
    }

    #[test]
    fn whoever_could_be_two_people_is_listed_and_so_is_whoever_is_nobody() {
        let all = entries(&["leesam_1_2_a.zip", "mallory"]);
        let placed = place(&all, Some(&people()));
        assert_eq!(placed.ambiguous["leesam_1_2_a.zip"].len(), 2);
        assert_eq!(placed.unknown, ["mallory"]);
        assert_eq!(placed.missing.len(), 5);
    }

    #[test]
    fn the_newest_attempt_counts_and_without_an_order_all_do() {
        let canvas = ["lovelaceada_9_70_a.zip", "lovelaceada_LATE_9_110_a-1.zip"];
        let placed = place(&entries(&canvas), None);
        assert_eq!(placed.superseded[canvas[0]], canvas[1]);
        let plain = ["s1", "Ada Lovelace_7_assignsubmission_file"];
        let placed = place(&entries(&plain), Some(&people()));
        assert!(placed.superseded.is_empty());
        assert_eq!(placed.several.len(), 1);
    }
}
