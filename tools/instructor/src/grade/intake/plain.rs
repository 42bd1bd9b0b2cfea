//! Whose submission a folder or an archive is, by its name.
//!
//! The university assigns ids and logins. People choose their logins on GitHub, the names of their
//! groups, and often addresses and display names, perhaps so that they look like somebody else's.
//! So unless a name is exactly an id or an assigned login, everyone is found who stands in it. If
//! these are several people, nobody knows whose it is. What most names of a class begin or end with
//! is the title of the assignment, and says nothing about people. Repositories on GitHub are found by
//! [`Repositories`].

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

use unicode_normalization::UnicodeNormalization;

use super::index::{Index, Kind, Match, words};
use super::matching::{Proof, folded, with_assigned};
use super::repositories::Repositories;
use super::roster::Person;

/// What most names of a class begin with: the longest such text that ends between two words. Nobody
/// can change what most names have in common.
pub fn title(names: &[&str]) -> String {
    in_common(names, |name| {
        let words = words(name).into_iter().skip(1);
        words.map(|it| &name[..it.start]).collect()
    })
}

/// What most names of a class end with, after a person's name.
fn ending(names: &[&str]) -> String {
    in_common(names, |name| {
        let words = words(name).into_iter().rev().skip(1);
        words.map(|it| &name[it.end..]).collect()
    })
}

/// The longest of the parts that most names have.
fn in_common(names: &[&str], parts: fn(&str) -> Vec<&str>) -> String {
    let mut count: BTreeMap<&str, usize> = BTreeMap::new();
    for part in names.iter().flat_map(|name| parts(name)) {
        *count.entry(part).or_default() += 1;
    }
    let most = count.into_iter();
    let most = most.filter(|(_, count)| *count > 1 && 2 * count > names.len());
    let longest = most.map(|(part, _)| part).max_by_key(|it| it.len());
    longest.unwrap_or_default().to_owned()
}

/// What the names of a class have in common, and the roster that they are compared with.
pub struct Convention<'a> {
    pub index: Index<'a>,
    /// The [`title`] of the names.
    title: String,
    /// The [`ending`] of the names.
    ending: String,
    /// How repositories on GitHub are named, if these are repositories.
    github: Option<Repositories<'a>>,
}

impl<'a> Convention<'a> {
    /// Looks at the names of a class.
    pub fn of(names: &[&str], people: &'a [Person]) -> Convention<'a> {
        let index = Index::of(people);
        let ending = ending(names);
        Convention {
            github: Repositories::of(names, &ending, &index),
            index,
            title: title(names),
            ending,
        }
    }

    /// Whether others have chosen a text that is this person's id or login. If the text names a
    /// folder, they may be meant.
    pub fn is_contested(&self, name: &str, person: &Person) -> bool {
        self.index.whole(name).any(|(it, _)| it != person)
    }

    /// The people that a name may mean, each once, and how much it proves if it means only one.
    pub fn meant(&self, name: &str) -> (Proof, Vec<&'a Person>) {
        let assigned = with_assigned(name, self.index.people);
        let github = self.github.as_ref();
        if !assigned.is_empty() {
            // On some platforms, people type in their own address.
            let is_id = assigned.iter().any(|it| it.id.eq_ignore_ascii_case(name));
            let proof = match is_id || !name.contains('@') {
                true => Proof::Id,
                false => Proof::Name,
            };
            return (proof, assigned);
        }
        if let Some((proof, owner)) = github.and_then(|it| it.owner(name)) {
            return (proof, vec![owner]);
        }
        let start = name
            .strip_prefix(&*self.title)
            .map_or(0, |_| self.title.len());
        let own = name[start..].strip_suffix(&*self.ending);
        let rest = start..own.map_or(name.len(), |it| start + it.len());
        // What lies within the title or the ending is nobody's.
        let all = self.index.find(name).into_iter();
        let all = all.filter(|it| it.kind != Kind::LoneName || it.covers(&rest, name));
        let all = all.filter(|it| !is_anothers_login(it, name));
        let all: Vec<_> = all.filter(|it| it.at.end > rest.start).collect();
        let own = all.iter().filter(|it| it.at.start < rest.end).cloned();
        let meant = without_accidents(own.collect(), name, &rest);
        let mut once: Vec<&Person> = Vec::new();
        let is_repository = github.is_some_and(|it| it.title(name).is_some());
        for found in &meant {
            let may_own = github.is_none_or(|it| it.may_own(found.person, name));
            if may_own && !once.contains(&found.person) {
                once.push(found.person);
            }
        }
        let is_strong = |it| self.is_strong(it, name, &rest);
        // A repository may belong to somebody whose login is not on the roster.
        let proof = match once[..] {
            [_] if !is_repository && meant.iter().any(is_strong) => Proof::Name,
            _ => Proof::Hint,
        };
        (proof, once)
    }

    /// Whether a match is enough to give the submission to the only person who is meant. Among other
    /// words, a display name is not, because it may be the login of somebody who is not on the
    /// roster.
    fn is_strong(&self, it: &Match, name: &str, rest: &Range<usize>) -> bool {
        match it.kind {
            Kind::Assigned => true,
            // If the title is known, nothing else stands before the login.
            Kind::Chosen if rest.start > 0 => it.covers(rest, name),
            Kind::Chosen => it.covers(&(it.at.start.min(rest.end)..rest.end), name),
            Kind::Name | Kind::LoneName => {
                let own = rest.start..rest.start + without_remark(&name[rest.clone()]).len();
                let has_spaces = name[own.clone()].contains(char::is_whitespace);
                it.covers(&(0..name.len()), name) || it.covers(&own, name) && has_spaces
            }
        }
    }
}

/// A text without a remark in brackets at its end, such as `(late)`.
fn without_remark(text: &str) -> &str {
    let opening = if text.ends_with(']') { " [" } else { " (" };
    let before = text.split_once(opening).map(|(before, _)| before);
    before
        .filter(|_| text.ends_with([')', ']']))
        .unwrap_or(text)
}

/// Leaves out what stands in a name by accident. A person's name may contain a login, and a remark
/// may contain a number.
fn without_accidents<'a>(all: Vec<Match<'a>>, name: &str, rest: &Range<usize>) -> Vec<Match<'a>> {
    let ids = all.iter().filter(|it| it.kind == Kind::Assigned);
    let by_both = ids.filter(|id| {
        let mut names = all
            .iter()
            .filter(|it| it.kind.is_name() && it.person == id.person);
        names.any(|it| it.at.end <= id.at.start || id.at.end <= it.at.start)
    });
    let by_both: BTreeSet<&str> = by_both.map(|it| &*it.person.id).collect();
    let is_written = all
        .iter()
        .any(|it| it.kind.is_name() && is_written_as(name, &it.person.name));
    let is_whole = |it: &Match| it.covers(rest, name);
    let has_title = rest.start > 0;
    let is_only_whole = is_written || has_title && all.iter().any(is_whole);
    let is_meant = |it: &Match| match by_both.len() {
        1 => by_both.contains(&*it.person.id),
        _ => !is_only_whole || is_whole(it) || it.kind.is_name() || it.at.start < rest.start,
    };
    all.into_iter().filter(is_meant).collect()
}

/// Whether a part of a name is like a person's login on GitHub, but has other hyphens, and so is somebody
/// else's.
fn is_anothers_login(it: &Match, name: &str) -> bool {
    let own = &name[it.at.clone()];
    let is_like = |chosen: &str| folded(chosen) == folded(own);
    let is_other = |login: &String| is_like(login) && !login.eq_ignore_ascii_case(own);
    let others = it.person.addresses().chain(it.person.group.as_deref());
    it.kind == Kind::Chosen
        && it.person.github.as_ref().is_some_and(is_other)
        && !others.into_iter().any(is_like)
}

/// Whether a name may be somebody's. What people have chosen counts only if `or_chosen`.
pub fn is_somebody(name: &str, index: &Index, or_chosen: bool) -> bool {
    let mut all = index.find(name).into_iter();
    let is = |it: Match| match it.kind {
        Kind::Assigned | Kind::Name => true,
        Kind::Chosen => or_chosen,
        Kind::LoneName => it.covers(&(0..name.len()), name),
    };
    all.any(is) || !with_assigned(name, index.people).is_empty()
}

/// Whether a text is a person's name as the roster writes it, with the last name first or last, and
/// contains nothing that isn't a part of names, such as a number.
fn is_written_as(text: &str, name: &str) -> bool {
    let is_of_names = |c: char| c.is_alphabetic() || c.is_whitespace() || ",.-'’".contains(c);
    if !text.nfc().all(is_of_names) {
        return false;
    }
    let words = |text: &str| -> Vec<String> {
        let words = text.split(|c: char| c.is_whitespace() || c == ',');
        let words = words.filter(|word| !word.is_empty());
        words
            .map(|word| word.nfc().collect::<String>().to_lowercase())
            .collect()
    };
    let (text, name) = (words(text), words(name));
    (0..name.len()).any(|k| [&name[k..], &name[..k]].concat() == text)
}

#[cfg(test)]
pub mod tests;
