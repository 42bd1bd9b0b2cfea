//! Whose repository on GitHub a folder is: its name is the title of the assignment, a hyphen, and the
//! login of a person or the name of a team.
//!
//! No two accounts have the same login, and a hyphen makes another one. So whoever has exactly this
//! login is meant, whatever others call themselves.

use std::cmp::Reverse;
use std::collections::{BTreeMap, HashMap};

use super::index::{Index, Kind, words};
use super::matching::{Proof, with_assigned, without_accents};
use super::roster::Person;

/// How the repositories of a class are named.
pub struct Repositories<'a> {
    /// What stands before the owner's name; empty if folders are named after the owners only.
    title: String,
    of: Owner,
    owners: HashMap<String, Vec<&'a Person>>,
    /// Whether the owners' names are not also the ids or the names of these people.
    is_sure: bool,
}

#[derive(Clone, Copy, Debug, Eq, Ord, PartialEq, PartialOrd)]
enum Owner {
    Person,
    Team,
}

impl<'a> Repositories<'a> {
    /// Looks at the names of a class. People choose the ends of names, but nobody shortens the title,
    /// so the shortest title counts that makes two names those of repositories. If more folders are named
    /// after the owners only, you have named them.
    pub fn of(names: &[&str], ending: &str, index: &Index<'a>) -> Option<Repositories<'a>> {
        let owners = [Owner::Person, Owner::Team].map(|of| (of, owners(of, index.people)));
        let mut counts: BTreeMap<(&str, Owner), (usize, usize)> = BTreeMap::new();
        // Folders may be named after assigned logins.
        let is_free = |name: &&&str| with_assigned(name, index.people).is_empty();
        for name in names.iter().filter(is_free) {
            let starts = words(name).into_iter().map(|it| it.start);
            for start in starts.filter(|at| *at == 0 || name[..*at].ends_with('-')) {
                let (title, rest) = name.split_at(start);
                for (of, owners) in &owners {
                    let Some((person, name)) = only(owners, rest, ending) else {
                        continue;
                    };
                    let mut own = index.whole(name).filter(|(it, _)| *it == person);
                    let (all, sure) = counts.entry((title, *of)).or_default();
                    *all += 1;
                    *sure += usize::from(own.all(|(_, kind)| kind == Kind::Chosen));
                }
            }
        }
        counts.retain(|_, (all, _)| *all > 1);
        let shortest = |is_empty| {
            let with = counts.iter();
            let with = with.filter(move |((title, _), _)| title.is_empty() == is_empty);
            with.min_by_key(|((title, of), (all, sure))| (title.len(), Reverse((*sure, *all)), *of))
        };
        let either = [shortest(false), shortest(true)].into_iter().flatten();
        let ((title, of), (_, sure)) = either.max_by_key(|(_, (all, _))| *all)?;
        let mut owners = owners.into_iter().filter(|(it, _)| it == of);
        Some(Repositories {
            title: (*title).into(),
            of: *of,
            owners: owners.next()?.1,
            is_sure: *sure > 1,
        })
    }

    /// Whether this is the name of a repository, perhaps of somebody whose login is not known.
    pub fn has(&self, name: &str) -> bool {
        !self.title.is_empty() && name.starts_with(&self.title)
    }

    /// Whether somebody may own something with this name. A repository of theirs is named after their
    /// login, perhaps with something behind it.
    pub fn may_own(&self, person: &Person, name: &str) -> bool {
        let login = person.github.as_ref().filter(|_| self.has(name));
        login.is_none_or(|login| {
            let (own, login) = (
                name[self.title.len()..].to_lowercase(),
                login.to_lowercase(),
            );
            let rest = own.strip_prefix(&login);
            self.of == Owner::Team || rest.is_some_and(|it| it.is_empty() || it.starts_with('-'))
        })
    }

    /// The owner of a repository with this name, and how much that proves. A login such as `ada-main`
    /// may also be somebody else's and a branch or a number, which GitHub adds.
    pub fn owner(
        &self,
        name: &str,
        ending: &str,
        index: &Index<'a>,
    ) -> Option<(Proof, &'a Person)> {
        let rest = name.strip_prefix(&*self.title)?;
        let (owner, own) = only(&self.owners, rest, ending)?;
        let mut others = index.whole(own).filter(|(it, _)| *it != owner);
        if !self.is_sure && others.any(|(_, kind)| kind != Kind::Chosen) {
            return None;
        }
        let is_added = |end: &str| {
            ["main", "master", "feedback"].contains(&end)
                || end.bytes().all(|it| it.is_ascii_digit())
        };
        let added = own.rsplit_once('-').map(|(_, end)| end);
        let may_be_longer = added
            .is_some_and(|end| is_added(end) || index.people.iter().any(|it| it.github.is_none()));
        let proof = match self.of == Owner::Person && !may_be_longer {
            true => Proof::Id,
            false => Proof::Given,
        };
        Some((proof, owner))
    }
}

/// What the owners of repositories are called on GitHub, in lower case.
fn owners(of: Owner, people: &[Person]) -> HashMap<String, Vec<&Person>> {
    let mut owners: HashMap<String, Vec<&Person>> = HashMap::new();
    for person in people {
        let names = match of {
            Owner::Person => person.github.iter().map(|it| it.to_lowercase()).collect(),
            Owner::Team => person.group.as_deref().map_or(Vec::new(), in_addresses),
        };
        for name in names {
            owners.entry(name).or_default().push(person);
        }
    }
    owners
}

/// How GitHub may write a team's name in addresses: without letters that aren't ASCII, or without
/// their accents.
fn in_addresses(team: &str) -> Vec<String> {
    let plain = |text: &str| {
        let text = text.to_lowercase();
        let words = text.split(|c: char| !c.is_ascii_alphanumeric());
        let words: Vec<&str> = words.filter(|it| !it.is_empty()).collect();
        words.join("-")
    };
    let mut all = vec![plain(team), plain(&without_accents(team))];
    all.dedup();
    all
}

/// The only owner with this name, perhaps before what most names end with, and the name.
fn only<'a, 't>(
    owners: &HashMap<String, Vec<&'a Person>>,
    text: &'t str,
    ending: &str,
) -> Option<(&'a Person, &'t str)> {
    let mut texts = [Some(text), text.strip_suffix(ending)]
        .into_iter()
        .flatten();
    texts.find_map(|text| match owners.get(&text.to_lowercase())?[..] {
        [only] => Some((only, text)),
        _ => None,
    })
}

#[cfg(test)]
mod tests;
