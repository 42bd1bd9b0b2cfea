//! Finds each submission's person on the roster. It never guesses: a submission that could belong
//! to several people, or whose names contradict each other, is listed, and belongs to nobody until
//! the roster settles whose it is. If only a name says who the person is, and nothing contradicts
//! it, the name is believed, but the submission is listed.

use std::collections::{BTreeMap, BTreeSet};

use serde::{Deserialize, Serialize};

use super::Entry;
use super::matching::{Proof, account, titled};
use super::names::Sign;
use super::plain::{Convention, Titles};
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
    /// Submissions whose person is known only by a name or a login, which people may have chosen
    /// themselves.
    #[serde(default)]
    pub by_name: Vec<String>,
    /// Submissions that may belong to several people, or that contradict themselves, and these
    /// people. They are graded.
    pub ambiguous: BTreeMap<String, Vec<Person>>,
    /// Earlier uploads, which are not graded, and the submission that is.
    pub superseded: BTreeMap<String, String>,
    /// People with several submissions. All are graded.
    pub several: BTreeMap<String, Vec<String>>,
}

impl Placement {
    /// People without a submission of their own who may have handed in an ambiguous one.
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

/// The people that a sign may mean, and how much it proves if it means only one.
fn meant<'a>(
    sign: &Sign,
    people: &'a [Person],
    convention: &Convention<'a>,
) -> (Proof, Vec<&'a Person>) {
    match sign {
        Sign::Login(text) => {
            let is_assigned = |(title, person): (&str, &Person)| {
                let mut all = [&person.id].into_iter().chain(&person.logins);
                all.any(|own| own.eq_ignore_ascii_case(&text[title.len()..]))
            };
            let proof = match titled(sign, people).into_iter().all(is_assigned) {
                true => Proof::Id,
                false => Proof::Name,
            };
            let owners = titled(sign, people).into_iter();
            (proof, owners.map(|(_, person)| person).collect())
        }
        Sign::Account {
            number,
            name,
            may_be_group,
        } => account(number, name, *may_be_group, people),
        Sign::Plain(name) => convention.meant(name),
    }
}

/// The people that an entry may belong to, each once, and how well that is proved.
fn owners<'a>(
    entry: &Entry,
    people: &'a [Person],
    convention: &Convention<'a>,
) -> (Proof, Vec<&'a Person>) {
    let all = entry.signs.iter();
    let all: Vec<_> = all.map(|sign| meant(sign, people, convention)).collect();
    let mut found: Vec<&Person> = Vec::new();
    for person in all.iter().flat_map(|(_, found)| found) {
        if !found.contains(person) {
            found.push(person);
        }
    }
    let agree = |of: &Vec<&Person>| of.iter().all(|it| found == [*it]) && !of.is_empty();
    // The name that the uploader gave a file can look like what the platform adds, as in
    // `lovelaceada_11_501_hw_2026_11_20.zip`. The platform's part comes first.
    let is_first = |all: &[(Proof, Vec<&Person>)]| match all {
        [(Proof::Id, of), others @ ..] => agree(of) && others.iter().all(|(_, of)| of.is_empty()),
        _ => false,
    };
    let proof = match all.iter().all(|(_, of)| agree(of)) {
        true => all.iter().map(|(proof, _)| *proof).min(),
        false => is_first(&all).then_some(Proof::Name),
    };
    let proof = proof.unwrap_or(Proof::Hint);
    (proof.min(entry.at_most), found)
}

/// Finds the person of each submission. Without a roster, it finds nobody.
pub fn place(entries: &[Entry], people: Option<&[Person]>) -> Placement {
    let mut placed = Placement {
        people: people.map(<[Person]>::len),
        ..Placement::default()
    };
    let Some(people) = people else { return placed };
    let titled_by = |entry: &Entry| -> BTreeSet<(String, String)> {
        let all = entry.signs.iter().flat_map(|sign| titled(sign, people));
        let owned = |(title, person): (&str, &Person)| (title.to_owned(), person.id.clone());
        all.map(owned).collect()
    };
    // An archive's author may have chosen a title that makes all others doubtful.
    let trusted = || entries.iter().filter(|entry| entry.at_most == Proof::Id);
    let mut titles = Titles::default();
    for entry in trusted() {
        let ways = titled_by(entry);
        titles.add(&ways.iter().map(|(title, id)| (&**title, &**id)).collect());
    }
    let plain = trusted().filter_map(|entry| match &entry.signs[..] {
        [Sign::Plain(name)] => Some(name.as_str()),
        _ => None,
    });
    let convention = Convention::of(&plain.collect::<Vec<_>>(), people);
    // If no other name begins like this, nothing shows where the title ends and the login begins.
    let is_lone = |title: &String| {
        let names = entries.iter().filter(|entry| entry.name.starts_with(title));
        names.take(2).count() < 2
    };
    // Beside uploads that no platform has named, somebody may have chosen a name like a platform's.
    let is_given = |entry: &&Entry| !matches!(entry.signs[..], [Sign::Plain(_)]);
    let is_export = 2 * entries.iter().filter(is_given).count() > entries.len();
    let mut of: BTreeMap<&str, Vec<(Proof, &Entry, &Person)>> = BTreeMap::new();
    for entry in entries {
        let (mut proof, found) = owners(entry, people, &convention);
        if !is_export && is_given(&entry) {
            proof = proof.min(Proof::Name);
        }
        let title = titled_by(entry).into_iter().next().map(|(title, _)| title);
        if title.as_ref().is_some_and(is_lone) {
            proof = proof.min(Proof::Name);
        }
        let is_part = |long: &str, short: &str| long.starts_with(short);
        let is_doubtful = title.is_some_and(|title| titles.is_doubtful(&title, is_part));
        match found[..] {
            [] => placed.unknown.push(entry.id.clone()),
            [person] if proof > Proof::Hint && !is_doubtful => {
                of.entry(&person.id)
                    .or_default()
                    .push((proof, entry, person));
            }
            _ => {
                let found = found.into_iter().cloned().collect();
                placed.ambiguous.insert(entry.id.clone(), found);
            }
        }
    }
    for (_, mut all) in of {
        // What a platform or the instructor says outweighs a name, and two accounts with one name
        // belong to two people.
        let best = all.iter().map(|(proof, ..)| *proof).max();
        let strongest = all.iter().filter(|(proof, ..)| Some(*proof) == best);
        let accounts = strongest.filter_map(|(proof, entry, _)| match &entry.signs[0] {
            Sign::Account { number, .. } => Some(number.clone()),
            Sign::Login(name) | Sign::Plain(name) => (*proof == Proof::Name).then(|| name.clone()),
        });
        let is_one = accounts.collect::<BTreeSet<_>>().len() < 2;
        let is_weak = |proof: Proof| Some(proof) != best || !is_one;
        for (_, entry, person) in all.extract_if(.., |it| is_weak(it.0)) {
            let person = vec![person.clone()];
            placed.ambiguous.insert(entry.id.clone(), person);
        }
        let mut ids: Vec<String> = all.iter().map(|it| it.1.id.clone()).collect();
        ids.sort();
        for (_, entry, person) in &all {
            placed.of.insert(entry.id.clone(), (*person).clone());
        }
        if best == Some(Proof::Name) {
            placed.by_name.extend(ids.clone());
        }
        if all.len() > 1 {
            placed.several.insert(ids[0].clone(), ids);
        }
    }
    let in_doubt: Vec<&Person> = placed.in_doubt();
    let handed_in: BTreeSet<&str> = placed.of.values().map(|it| it.id.as_str()).collect();
    let is_missing =
        |person: &&Person| !handed_in.contains(person.id.as_str()) && !in_doubt.contains(person);
    let missing: Vec<Person> = people.iter().filter(is_missing).cloned().collect();
    placed.missing = missing;
    placed
}

#[cfg(test)]
pub mod tests;
