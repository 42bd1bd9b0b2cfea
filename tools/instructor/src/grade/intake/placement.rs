//! Finds each submission's person on the roster. It never guesses: a submission that could belong
//! to several people, or whose names contradict each other, is listed, and belongs to nobody until
//! the roster settles whose it is. If only a name says who the person is, and nothing contradicts
//! it, the name is believed, but the submission is listed.

use std::collections::{BTreeMap, BTreeSet};

use serde::{Deserialize, Serialize};

use super::Entry;
use super::account::{with_account, with_login};
use super::index::{Index, once};
use super::matching::Proof;
use super::names::Sign;
use super::pattern::NamePattern;
use super::plain;
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
    /// Submissions whose person is known by an id or a login, but the instructor should check it,
    /// perhaps because somebody else has chosen it for a name or a login.
    #[serde(default)]
    pub contested: Vec<String>,
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

/// How the submissions of a class are named, and its roster.
struct Names<'a> {
    index: Index<'a>,
    named: &'a NamePattern,
}

impl<'a> Names<'a> {
    fn is_contested(&self, entry: &Entry, person: &Person) -> bool {
        match &entry.signs[..] {
            [Sign::Plain(name)] => plain::is_contested(name, person, self.named, &self.index),
            [Sign::Login(text)] => {
                let is_other = self
                    .named
                    .own(text)
                    .is_some_and(|it| has_other_login(it, person));
                is_other || plain::is_contested(text, person, self.named, &self.index)
            }
            _ => false,
        }
    }

    /// The people that a sign may mean, and how much it proves if it means only one.
    fn meant(&self, sign: &Sign) -> (Proof, Vec<&'a Person>) {
        match sign {
            Sign::Login(text) if self.named.is_login(sign) => {
                plain::meant(text, self.named, &self.index)
            }
            Sign::Login(text) => with_login(text, &self.index),
            Sign::Account {
                number,
                name,
                may_be_group,
            } => with_account(number, name, *may_be_group, &self.index),
            Sign::Plain(name) => {
                let (proof, found) = plain::meant(name, self.named, &self.index);
                match plain::may_be_anothers(name, self.named, &self.index) {
                    true => (proof.min(Proof::Name), found),
                    false => (proof, found),
                }
            }
        }
    }
}

/// Whether the university assigned other logins than this one to a person. It may be somebody else's
/// then, even if it is the person's id.
fn has_other_login(login: &str, person: &Person) -> bool {
    let own: Vec<&String> = person.assigned_logins().collect();
    !own.is_empty() && !own.iter().any(|own| own.eq_ignore_ascii_case(login))
}

/// The people that an entry may belong to, each once, and how well that is proved.
fn owners<'a>(entry: &Entry, names: &Names<'a>) -> (Proof, Vec<&'a Person>) {
    let all: Vec<_> = entry.signs.iter().map(|sign| names.meant(sign)).collect();
    let found = once(all.iter().flat_map(|(_, found)| found.iter().copied()));
    let agree = |of: &Vec<&Person>| of.iter().all(|it| found == [*it]) && !of.is_empty();
    // The name that the uploader gave a file can look like what the platform adds, as in
    // `lovelaceada_11_501_hw_2026_11_20.zip`. The platform's part comes first. But nobody writes by
    // chance what Moodle adds, so it may stand in a display name on another platform.
    let first = all.first().filter(|(_, of)| !of.is_empty());
    let is_moodles = entry.signs.iter().any(|sign| sign.may_be_group());
    let is_first = first.is_some_and(|(proof, _)| *proof == Proof::Id) && !is_moodles;
    let proof = match all.iter().all(|(_, of)| agree(of)) {
        true => all.iter().map(|(proof, _)| *proof).min(),
        false => is_first.then_some(Proof::Name),
    };
    let proof = proof.unwrap_or(Proof::Hint);
    (proof.min(entry.at_most), found)
}

/// Finds the person of each submission. Without a roster, it finds nobody. `named` says how folders and
/// archives are named.
pub fn place(entries: &[Entry], people: Option<&[Person]>, named: &NamePattern) -> Placement {
    let mut placed = Placement {
        people: people.map(<[Person]>::len),
        ..Placement::default()
    };
    let Some(people) = people else { return placed };
    let names = Names {
        index: Index::of(people),
        named,
    };
    // Beside uploads that no platform has named, somebody may have chosen a name like a platform's.
    let is_given = |entry: &&Entry| !matches!(entry.signs[..], [Sign::Plain(_)]);
    let is_platforms = |entry: &&Entry| entry.signs.iter().any(|it| named.is_platforms(it));
    let given = entries.iter().filter(is_platforms).count();
    let is_export = given > 1 && 2 * given > entries.len();
    let meant: Vec<_> = entries.iter().map(|entry| owners(entry, &names)).collect();
    // How many submissions may be a person's, without those that may be somebody's copies.
    let mut count: BTreeMap<&str, usize> = BTreeMap::new();
    let own = entries.iter().zip(&meant);
    let own = own.filter(|(entry, _)| entry.at_most > Proof::Hint);
    for person in own.flat_map(|(_, (_, found))| found) {
        *count.entry(&person.id).or_default() += 1;
    }
    let mut of: BTreeMap<&str, Vec<(Proof, &Entry, &Person)>> = BTreeMap::new();
    for (entry, (mut proof, found)) in entries.iter().zip(meant) {
        let is_foreign = entry.platform.is_some_and(|of| !entry.is_of(of));
        if (!is_export || is_foreign) && is_given(&entry) {
            proof = proof.min(Proof::Name);
        }
        match found[..] {
            [] => placed.unknown.push(entry.id.clone()),
            [person] if proof > Proof::Hint => {
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
    for (id, mut all) in of {
        // What a platform or the instructor says outweighs a name. A name counts only if nothing else
        // may be this person's. Two accounts with one name, or two names that people may have chosen,
        // belong to two people.
        let best = all.iter().map(|(proof, ..)| *proof).max();
        let strongest = all.iter().filter(|(proof, ..)| Some(*proof) == best);
        let accounts = strongest.filter_map(|(proof, entry, _)| match &entry.signs[..] {
            [Sign::Account { number, .. }] => Some(number),
            [Sign::Login(name)] => (*proof < Proof::Id).then_some(name),
            [Sign::Plain(_)] if *proof == Proof::Id => None,
            _ => Some(&entry.id),
        });
        let is_one = accounts.collect::<BTreeSet<_>>().len() < 2
            && (best > Some(Proof::Name) || count.get(id) == Some(&all.len()));
        for (_, entry, person) in all.extract_if(.., |it| Some(it.0) != best || !is_one) {
            let person = vec![person.clone()];
            placed.ambiguous.insert(entry.id.clone(), person);
        }
        let mut ids: Vec<String> = all.iter().map(|it| it.1.id.clone()).collect();
        ids.sort();
        for (_, entry, person) in &all {
            placed.of.insert(entry.id.clone(), (*person).clone());
        }
        for (proof, entry, person) in &all {
            match proof {
                Proof::Hint | Proof::Name => placed.by_name.push(entry.id.clone()),
                Proof::Id if !names.is_contested(entry, person) => {}
                Proof::Given | Proof::Id => placed.contested.push(entry.id.clone()),
            }
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
