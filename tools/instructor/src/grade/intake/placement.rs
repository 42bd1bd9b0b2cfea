//! Finds each submission's person on the roster. It never guesses: a submission that could
//! belong to several people, or contradicts itself, is listed, and belongs to nobody until the
//! roster says so.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};
use unicode_normalization::UnicodeNormalization;
use unicode_normalization::char::is_combining_mark;

use super::Entry;
use super::names::Sign;
use super::roster::Person;

/// Which submission belongs to which person, and which could not be placed.
#[derive(Clone, Debug, Default, Deserialize, PartialEq, Serialize)]
pub struct Placement {
    /// How many people are on the roster, if there is one.
    pub people: Option<usize>,
    /// The person of each submission, by the submission's id.
    pub of: BTreeMap<String, Person>,
    /// People without a submission, not even one that might be theirs.
    pub missing: Vec<Person>,
    /// Submissions by people who are not on the roster. They are graded.
    pub unknown: Vec<String>,
    /// Submissions that may belong to several people, or that contradict themselves, and these
    /// people. They are graded.
    pub ambiguous: BTreeMap<String, Vec<Person>>,
    /// Earlier uploads, which are not graded, and the submission that is.
    pub superseded: BTreeMap<String, String>,
    /// People with several submissions whose names don't say which came last. All are graded.
    pub several: BTreeMap<String, Vec<String>>,
}

impl Placement {
    /// People who may have handed in one of these submissions, though it is not certain which.
    pub fn in_doubt(&self) -> Vec<&Person> {
        let mut people: Vec<&Person> = Vec::new();
        let placed = |person: &Person| self.of.values().any(|other| other.id == person.id);
        for person in self.ambiguous.values().flatten() {
            if !placed(person) && !people.contains(&person) {
                people.push(person);
            }
        }
        people
    }
}

/// The letters and digits of a text in lower case, with accents composed.
fn folded(text: &str) -> String {
    let composed: String = text.nfc().collect();
    let kept = composed.chars().filter(|c| c.is_alphanumeric());
    kept.flat_map(char::to_lowercase).collect()
}

/// The letters and digits of a text in lower case, without accents.
fn unaccented(text: &str) -> String {
    let letters: String = text.nfkd().filter(|c| !is_combining_mark(*c)).collect();
    folded(&letters)
}

/// The ways to write a name in one word, with the last name first or last.
fn turned(name: &str, fold: &dyn Fn(&str) -> String) -> Vec<String> {
    let words: Vec<String> = name
        .split(|c: char| c.is_whitespace() || c == ',')
        .map(fold)
        .filter(|word| !word.is_empty())
        .collect();
    let turned = |k: usize| [&words[k..], &words[..k]].concat().concat();
    (0..words.len()).map(turned).collect()
}

/// The people of this name. Platforms keep accents, drop them, or drop letters that have one.
fn named<'a>(name: &str, people: &'a [Person]) -> Vec<&'a Person> {
    let ascii = |text: &str| -> String { folded(text).chars().filter(char::is_ascii).collect() };
    let folds: [&dyn Fn(&str) -> String; 3] = [&folded, &unaccented, &ascii];
    let found = folds.iter().map(|fold| {
        let person = match fold(name) {
            person if person.is_empty() => return Vec::new(),
            person => person,
        };
        let is = |other: &&Person| turned(&other.name, fold).contains(&person);
        people.iter().filter(is).collect::<Vec<_>>()
    });
    found
        .into_iter()
        .find(|found| !found.is_empty())
        .unwrap_or_default()
}

/// The people with this id or login.
fn with_id<'a>(id: &str, people: &'a [Person]) -> Vec<&'a Person> {
    let id = folded(id);
    let is = |other: &&Person| {
        let whole = other.logins.iter().map(String::as_str);
        let local = whole.clone().filter_map(|login| login.split('@').next());
        let mut all = whole.chain(local).chain([other.id.as_str()]);
        !id.is_empty() && all.any(|it| folded(it) == id)
    };
    people.iter().filter(is).collect()
}

/// Whether a name may be somebody's.
pub fn is_somebody(name: &str, people: &[Person]) -> bool {
    let sign = Sign {
        person: name.into(),
        number: None,
    };
    !meant(&sign, people).is_empty()
}

/// The people whose id or full name is among a name's words, as in `homework1-adalovelace`.
fn among_words<'a>(name: &str, people: &'a [Person]) -> Vec<&'a Person> {
    let words: Vec<String> = name
        .split(|c: char| !c.is_alphanumeric() && !is_combining_mark(c))
        .map(folded)
        .filter(|word| !word.is_empty())
        .collect();
    let runs = |is: &dyn Fn(&str) -> bool| {
        let starts = 0..words.len();
        starts
            .into_iter()
            .any(|k| (k..words.len()).any(|end| is(&words[k..=end].concat())))
    };
    let is = |other: &&Person| {
        let is_name = other.name.split_whitespace().count() > 1
            && runs(&|run| turned(&other.name, &folded).iter().any(|name| name == run));
        let is_id = words
            .iter()
            .any(|word| with_id(word, std::slice::from_ref(*other)).len() == 1);
        is_name || is_id
    };
    people.iter().filter(is).collect()
}

/// The people that a name or number may mean: one, if it is certain.
fn meant<'a>(sign: &Sign, people: &'a [Person]) -> Vec<&'a Person> {
    let Some(number) = &sign.number else {
        let found = [
            with_id(&sign.person, people),
            named(&sign.person, people),
            among_words(&sign.person, people),
        ];
        return found
            .into_iter()
            .find(|found| !found.is_empty())
            .unwrap_or_default();
    };
    // Trust the platform's number more than names, because people choose their names
    // themselves.
    let own = |other: &&Person| other.number.as_ref() == Some(number);
    if let Some(person) = people.iter().find(own) {
        return vec![person];
    }
    let mut by_name = named(&sign.person, people);
    by_name.extend(with_id(&sign.person, people));
    by_name.retain(|other| other.number.is_none());
    let is_id = |other: &&Person| other.number.is_none() && other.id == *number;
    let by_id: Vec<&Person> = people.iter().filter(is_id).collect();
    let agrees = |other: &&Person| by_id.is_empty() || by_id.contains(other);
    match by_name.iter().copied().filter(agrees).collect::<Vec<_>>() {
        both if both.is_empty() => [by_name, by_id].concat(),
        both => both,
    }
}

/// Whether the signs leave no doubt about the person.
fn is_certain(signs: &[Sign], people: &[Person], found: &[&Person]) -> bool {
    let [person] = found else { return false };
    signs.iter().all(|sign| {
        let alone = std::slice::from_ref(*person);
        let is_named =
            !named(&sign.person, alone).is_empty() || !with_id(&sign.person, alone).is_empty();
        let is_account = sign.number.is_some() && sign.number == person.number;
        // A number in a name may equal somebody else's id by chance.
        let is_meant = meant(sign, people) == [*person];
        is_meant && (sign.number.is_none() || is_account || is_named)
    })
}

/// Finds the person of each submission. Without a roster, there are none.
pub fn place(entries: &[Entry], people: Option<&[Person]>) -> Placement {
    let mut placed = Placement {
        people: people.map(<[Person]>::len),
        ..Placement::default()
    };
    let Some(people) = people else { return placed };
    let mut of: BTreeMap<&str, Vec<(&Entry, &Person)>> = BTreeMap::new();
    for entry in entries {
        let mut found: Vec<&Person> = Vec::new();
        for person in entry.signs.iter().flat_map(|sign| meant(sign, people)) {
            if !found.contains(&person) {
                found.push(person);
            }
        }
        match found[..] {
            [] => placed.unknown.push(entry.id.clone()),
            [person] if is_certain(&entry.signs, people, &found) => {
                of.entry(&person.id).or_default().push((entry, person));
            }
            _ => {
                let found = found.into_iter().cloned().collect();
                placed.ambiguous.insert(entry.id.clone(), found);
            }
        }
    }
    for (_, all) in of {
        let numbers = all.iter().map(|(entry, _)| &entry.signs[0].number);
        let mut numbers: Vec<_> = numbers.flatten().collect();
        numbers.sort();
        numbers.dedup();
        let mut ids: Vec<String> = all.iter().map(|(entry, _)| entry.id.clone()).collect();
        ids.sort();
        for (entry, person) in &all {
            // Two accounts belong to two people, even if their names are equal.
            match numbers.len() > 1 {
                true => {
                    placed
                        .ambiguous
                        .insert(entry.id.clone(), vec![(*person).clone()]);
                }
                false => {
                    placed.of.insert(entry.id.clone(), (*person).clone());
                }
            }
        }
        if numbers.len() < 2 && all.len() > 1 {
            placed.several.insert(ids[0].clone(), ids);
        }
    }
    let in_doubt: Vec<&Person> = placed.in_doubt();
    let is_missing = |person: &&Person| {
        let handed_in = placed.of.values().any(|other| other.id == person.id);
        !handed_in && !in_doubt.contains(person)
    };
    let missing: Vec<Person> = people.iter().filter(is_missing).cloned().collect();
    placed.missing = missing;
    placed
}

#[cfg(test)]
mod tests;
