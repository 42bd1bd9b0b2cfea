//! Whose submission a folder or an archive is, by its name.
//!
//! The university assigns ids and logins. People choose their logins on GitHub, the names of their
//! groups, and often addresses and display names, perhaps so that they look like somebody else's.
//! So only a whole name, or the part of it that the instructor has shown by a [`NamePattern`], says
//! whose a submission is. People who merely stand in a name are suggested to the instructor.

use super::index::{Index, Kind, Match};
use super::matching::{Proof, with_assigned};
use super::pattern::{Key, NamePattern};
use super::roster::Person;

/// The people that a name may mean, each once, and how much it proves if it means only one.
pub fn meant<'a>(
    name: &str,
    patterns: &[NamePattern],
    index: &Index<'a>,
) -> (Proof, Vec<&'a Person>) {
    let all = parts(name, patterns).map(|(part, of)| of.owners(part, index));
    let mut all: Vec<_> = all.filter(|(_, found)| !found.is_empty()).collect();
    let Some(best) = all.iter().map(|(proof, _)| *proof).max() else {
        return (Proof::Hint, suggested(name, patterns, index));
    };
    // Somebody may have chosen the name of a person that is another's id.
    all.retain(|(proof, _)| *proof > Proof::Name || best <= Proof::Name);
    (best, once(all.into_iter().flat_map(|(_, found)| found)))
}

/// The people who stand in a name.
fn suggested<'a>(name: &str, patterns: &[NamePattern], index: &Index<'a>) -> Vec<&'a Person> {
    let near = |part| {
        let all = index.find(part).into_iter();
        all.filter(move |it| it.kind != Kind::LoneName || it.is_all_of(part))
    };
    let all = parts(name, patterns).flat_map(|(part, _)| near(part));
    once(all.map(|it| it.person))
}

/// Whether others have chosen a text that is this person's id or login. If the text names a folder,
/// they may be meant.
pub fn is_contested(name: &str, person: &Person, patterns: &[NamePattern], index: &Index) -> bool {
    let ids = parts(name, patterns).filter(|(_, of)| of.key() == Key::Id);
    let mut others = ids.flat_map(|(part, _)| index.whole(part));
    others.any(|(it, _)| it != person)
}

/// The parts of a name that may say whose it is: all of it, and those of the patterns that it has.
fn parts<'n>(
    name: &'n str,
    patterns: &[NamePattern],
) -> impl Iterator<Item = (&'n str, NamePattern)> {
    let whole = NamePattern::id();
    let others = patterns.iter().filter(move |it| **it != NamePattern::id());
    let all = std::iter::once(whole).chain(others.cloned());
    all.filter_map(move |it| Some((it.own(name)?, it)))
}

/// The same people, each once.
pub fn once<'a>(all: impl IntoIterator<Item = &'a Person>) -> Vec<&'a Person> {
    let mut once: Vec<&Person> = Vec::new();
    for person in all {
        if !once.contains(&person) {
            once.push(person);
        }
    }
    once
}

/// Whether a name may be somebody's. What people have chosen counts only if `or_chosen`.
pub fn is_somebody(name: &str, index: &Index, or_chosen: bool) -> bool {
    let mut all = index.find(name).into_iter();
    let is = |it: Match| match it.kind {
        Kind::Assigned | Kind::Name => true,
        Kind::Chosen => or_chosen,
        Kind::LoneName => it.is_all_of(name),
    };
    all.any(is) || !with_assigned(name, index.people).is_empty()
}

#[cfg(test)]
pub mod tests;
