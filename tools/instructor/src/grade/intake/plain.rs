//! Whose submission a folder or an archive is, by its name.
//!
//! The university assigns ids and logins. People choose their logins on GitHub, the names of their
//! groups, and often addresses and display names, perhaps so that they look like somebody else's.
//! So unless a name is exactly an id or an assigned login, everyone is found whom it may mean. If
//! these are several people, nobody knows whose it is. In a class, what stands before or after the
//! logins of several people is a title of the assignment, and says nothing about people.

use std::collections::{BTreeMap, BTreeSet};

use unicode_normalization::UnicodeNormalization;

use super::index::Index;
use super::matching::{
    Proof, calling_themselves, has_assigned_id, is_id, named, named_among, with_chosen_login,
    with_id,
};
use super::roster::Person;

/// What the names of a class have in common.
#[derive(Default)]
pub struct Convention<'a> {
    index: Index<'a>,
    before: Vec<String>,
    after: Vec<String>,
    /// Titles before logins on GitHub.
    on_github: Vec<String>,
    /// What stands before the logins of anybody.
    titles: Titles,
    /// Which of these may end in another login.
    doubtful: Vec<String>,
    /// The ids of people whom most names may mean besides somebody else. They have chosen a word
    /// that most names have, such as `ray` in `ray-casting-ada`.
    common: BTreeSet<String>,
}

impl<'a> Convention<'a> {
    /// Looks at the names of a class.
    pub fn of(names: &[&str], people: &'a [Person]) -> Convention<'a> {
        let index = Index::of(people);
        let [mut before, mut after, mut on_github] = [(); 3].map(|()| Titles::default());
        // A person's whole name has no title, even if it ends in a login that another has chosen.
        for name in names {
            let near = near(&index, name);
            if named(name, &near).is_empty() {
                before.add(&titles_before(name, &near, all_logins));
                on_github.add(&titles_before(name, &near, |it| {
                    Box::new(it.github.as_deref().into_iter())
                }));
                after.add(&titles_after(name, &near));
            }
        }
        let starts = |long: &str, short: &str| long.starts_with(short);
        let doubtful = before.0.keys().filter(|it| before.is_doubtful(it, starts));
        let mut convention = Convention {
            index,
            doubtful: doubtful.cloned().collect(),
            before: before.certain(starts),
            after: after.certain(|long, short| long.ends_with(short)),
            on_github: on_github.certain(starts),
            titles: before,
            common: BTreeSet::new(),
        };
        convention.common = convention.common(names);
        convention
    }

    fn common(&self, names: &[&str]) -> BTreeSet<String> {
        let mut besides: BTreeMap<&str, BTreeSet<&str>> = BTreeMap::new();
        for name in names {
            let (_, found) = self.meant(name);
            for person in &found {
                let others = found.iter().filter(|other| *other != person);
                let besides = besides.entry(&person.id).or_default();
                besides.extend(others.map(|other| &*other.id));
            }
        }
        let half = besides.len() / 2;
        let common = besides
            .iter()
            .filter(|(_, others)| others.len() > half.max(1));
        common.map(|(id, _)| (*id).to_owned()).collect()
    }

    /// A name without the title, and whether it has one.
    fn without_title<'n>(&self, name: &'n str) -> (&'n str, bool) {
        let before = self
            .before
            .iter()
            .find_map(|title| name.strip_prefix(&**title));
        let after = || {
            self.after
                .iter()
                .find_map(|title| name.strip_suffix(&**title))
        };
        let rest = before.or_else(after).filter(|rest| !rest.is_empty());
        (rest.unwrap_or(name), rest.is_some())
    }

    /// Whether a login that a person has chosen ends a text, and what stands before it may be a title.
    fn ends_with_chosen(&self, text: &str, person: &Person) -> bool {
        let mut titles = before_chosen(text, person);
        titles.any(|title| !self.doubtful.iter().any(|it| it == title))
    }

    /// The people that a name may mean, each once, and how much it proves if it means only one.
    pub fn meant(&self, name: &str) -> (Proof, Vec<&'a Person>) {
        let people = self.index.near(name);
        let near = near(&self.index, name);
        let (proof, found) = self.meant_among(name, &near);
        let is_found = |it: &&&Person| found.iter().any(|found| found.id == it.id);
        (proof, people.iter().filter(is_found).copied().collect())
    }

    fn meant_among<'p>(&self, name: &str, people: &'p [Person]) -> (Proof, Vec<&'p Person>) {
        if is_id(name, people) {
            return (Proof::Id, with_id(name, people));
        }
        let (rest, has_title) = self.without_title(name);
        let is_name = !named(name, people).is_empty();
        let is_login = !whole(rest, people).is_empty();
        let found = match (is_name, is_login) {
            (true, _) => self.with_name(name, people),
            (false, true) => self.with_login(name, people),
            (false, false) => self.with_part(name, people),
        };
        let mut once: Vec<&Person> = Vec::new();
        for person in found {
            if !once.contains(&person) {
                once.push(person);
            }
        }
        match once[..] {
            [_] if is_name => (Proof::Name, once),
            [person] if is_login && has_title => (self.of_login(name, rest, person, people), once),
            [_] if is_login => (Proof::Name, once),
            [person] => (self.of_part(rest, person), once),
            _ => (Proof::Hint, once),
        }
    }

    /// The people that may be meant by a name that some of them have. If it is written as on the
    /// roster, it is nobody's login.
    fn with_name<'p>(&self, name: &str, people: &'p [Person]) -> Vec<&'p Person> {
        let mut found = whole(name, people);
        found.extend(self.rare(with_assigned_among(name, people)));
        if let (rest, true) = self.without_title(name) {
            found.extend(whole(rest, people));
        }
        if !named(name, people)
            .iter()
            .all(|it| is_written_as(name, &it.name))
        {
            found.extend(named_among(name, people));
            let is_outermost =
                |it: &&Person| is_beside_remark(name, it) || self.ends_with_chosen(name, it);
            let chosen = self.rare(with_chosen_among(name, people));
            found.extend(chosen.filter(is_outermost));
        }
        // Somebody may have chosen the title and another's login for a name.
        let is_after_title = |person: &&Person| {
            let mut titles = before_chosen(name, person);
            titles.any(|title| self.titles.0.contains_key(title))
        };
        found.extend(people.iter().filter(is_after_title));
        found
    }

    /// The people that may be meant by a name that is, after a title, the login of some of them, or
    /// the name of their group. What looks like the title may contain a part of somebody's name.
    fn with_login<'p>(&self, name: &str, people: &'p [Person]) -> Vec<&'p Person> {
        let (rest, has_title) = self.without_title(name);
        let mut found = whole(rest, people);
        found.extend(self.rare(with_assigned_among(rest, people)));
        found.extend(self.rare(named_among(name, people)));
        if !has_title {
            found.extend(self.rare(with_chosen_among(name, people)));
        }
        found
    }

    /// The people that may be meant by a part of a name. If an id and a name agree, no other id or
    /// name counts, because a name may contain a login, and a title may contain a number.
    fn with_part<'p>(&self, name: &str, people: &'p [Person]) -> Vec<&'p Person> {
        let (rest, _) = self.without_title(name);
        let assigned: Vec<_> = self.rare(with_assigned_among(rest, people)).collect();
        let names: Vec<_> = self.rare(named_among(name, people)).collect();
        let both: Vec<_> = assigned
            .iter()
            .copied()
            .filter(|it| names.contains(it))
            .collect();
        let mut found = match both.len() {
            1 => both,
            _ => [&assigned[..], &names].concat(),
        };
        let outermost: Vec<_> = assigned
            .iter()
            .filter(|it| is_outermost(rest, it))
            .collect();
        match outermost.is_empty() {
            true => found.extend(self.rare(with_chosen_among(rest, people))),
            false => {
                let has_id = |it: &&Person| outermost.iter().any(|own| has_id_for_github(it, own));
                found.extend(people.iter().filter(has_id));
            }
        }
        found
    }

    /// Those who are not in what most names have in common.
    fn rare<'p>(&self, found: Vec<&'p Person>) -> impl Iterator<Item = &'p Person> {
        found.into_iter().filter(|it| !self.common.contains(&it.id))
    }

    /// How much a text proves that may be a person's login, because it stands beside a title.
    fn of_login(&self, name: &str, text: &str, person: &Person, people: &[Person]) -> Proof {
        let is = |own: &str| own.eq_ignore_ascii_case(text);
        let is_on_github = person.github.as_deref().is_some_and(is);
        let is_name = !named(text, std::slice::from_ref(person)).is_empty();
        let is_login = assigned(person).chain(chosen(person)).any(is);
        let title = name.strip_suffix(text);
        let has_title = title.is_some_and(|title| self.on_github.iter().any(|it| it == title));
        if is_on_github && has_title && !contains_anothers(text, person, people) {
            return Proof::Id;
        }
        match is_name && !is_login && !text.contains(char::is_whitespace) {
            true => Proof::Hint,
            false => Proof::Name,
        }
    }

    /// How much a part of a text proves that is a person's.
    fn of_part(&self, text: &str, person: &Person) -> Proof {
        let is_assigned = assigned(person).any(|own| places(text, own).next().is_some());
        match is_assigned || self.ends_with_chosen(text, person) {
            true => Proof::Name,
            false => Proof::Hint,
        }
    }
}

/// The people whose id, login, name or group this is, perhaps with other punctuation.
fn whole<'a>(text: &str, people: &'a [Person]) -> Vec<&'a Person> {
    let mut found = with_id(text, people);
    found.extend(with_chosen_login(text, people));
    found.extend(calling_themselves(text, people, |it| it.github.as_ref()));
    found.extend(calling_themselves(text, people, |it| it.group.as_ref()));
    found.extend(named(text, people));
    found
}

/// The id and the logins of a person, as the university assigned them.
fn assigned(person: &Person) -> impl Iterator<Item = &str> {
    let id = has_assigned_id(person).then_some(&person.id);
    id.into_iter().chain(&person.logins).map(String::as_str)
}

/// What a person may have chosen: a login on GitHub, the beginnings of addresses, and the name of a
/// group.
fn chosen(person: &Person) -> impl Iterator<Item = &str> {
    let addresses = person.logins.iter().filter_map(|it| it.split_once('@'));
    let locals = addresses.map(|(local, _)| local);
    let others = person.github.iter().chain(&person.group);
    locals.chain(others.map(String::as_str))
}

fn is_edge(c: Option<char>) -> bool {
    !c.is_some_and(char::is_alphanumeric)
}

/// Copies of the people who share a word with a name.
fn near(index: &Index, name: &str) -> Vec<Person> {
    index.near(name).into_iter().cloned().collect()
}

/// Whether a name may be somebody's. What people have chosen counts only if `or_chosen`.
pub fn is_somebody(name: &str, index: &Index, or_chosen: bool) -> bool {
    let people = &near(index, name)[..];
    !with_id(name, people).is_empty()
        || !named(name, people).is_empty()
        || !with_assigned_among(name, people).is_empty()
        || !named_among(name, people).is_empty()
        || or_chosen && !whole(name, people).is_empty()
        || or_chosen && !with_chosen_among(name, people).is_empty()
}

/// Where a text contains another as whole words, in capitals or not.
fn places<'t>(text: &'t str, own: &'t str) -> impl Iterator<Item = usize> + 't {
    let starts = text.char_indices().map(|(at, _)| at);
    starts.filter(move |at| {
        let Some(found) = text.get(*at..at + own.len()) else {
            return false;
        };
        found.eq_ignore_ascii_case(own)
            && !own.is_empty()
            && is_edge(text[..*at].chars().next_back())
            && is_edge(text[at + own.len()..].chars().next())
    })
}

/// The people with an assigned id or login among a text's words.
fn with_assigned_among<'a>(text: &str, people: &'a [Person]) -> Vec<&'a Person> {
    let has = |person: &&Person| assigned(person).any(|own| places(text, own).next().is_some());
    people.iter().filter(has).collect()
}

/// The people with a chosen login among a text's words.
fn with_chosen_among<'a>(text: &str, people: &'a [Person]) -> Vec<&'a Person> {
    let has = |person: &&Person| chosen(person).any(|own| places(text, own).next().is_some());
    people.iter().filter(has).collect()
}

/// Whether somebody has chosen a login on GitHub that is another's assigned id or login.
fn has_id_for_github(person: &Person, other: &Person) -> bool {
    let github = person.github.as_deref();
    github.is_some_and(|it| assigned(other).any(|own| own.eq_ignore_ascii_case(it)))
}

/// Whether an assigned id or login begins or ends a text. Within a text, a number may be a part of
/// the title.
fn is_outermost(text: &str, person: &Person) -> bool {
    let is = |own: &str| places(text, own).any(|at| at == 0 || at + own.len() == text.len());
    assigned(person).any(is)
}

/// Whether a login that a person has chosen begins a text that ends in brackets, such as `ada (late)`.
fn is_beside_remark(text: &str, person: &Person) -> bool {
    text.ends_with([')', ']']) && chosen(person).any(|own| places(text, own).next() == Some(0))
}

/// Whether another's login is among the words of a person's, such as `ada-main`. GitHub adds branches
/// to the names of archives, and a longer title may end in a word before the login.
fn contains_anothers(text: &str, person: &Person, people: &[Person]) -> bool {
    let mut others = people.iter().filter(|it| it.id != person.id);
    others.any(|other| all_logins(other).any(|own| places(text, own).next().is_some()))
}

/// What stands before each login that ends a text and that a person has chosen.
fn before_chosen<'t>(text: &'t str, person: &'t Person) -> impl Iterator<Item = &'t str> {
    let ends = |own: &'t str| places(text, own).filter(|at| at + own.len() == text.len());
    chosen(person).flat_map(ends).map(|at| &text[..at])
}

/// What was assigned to a person, and what the person may have chosen.
fn all_logins(person: &Person) -> Box<dyn Iterator<Item = &str> + '_> {
    Box::new(assigned(person).chain(chosen(person)))
}

/// What stands before each of these logins that ends a name, and the login's person.
fn titles_before<'a, 'n>(
    name: &'n str,
    people: &'a [Person],
    logins: fn(&Person) -> Box<dyn Iterator<Item = &str> + '_>,
) -> BTreeSet<(&'n str, &'a str)> {
    let mut found = BTreeSet::new();
    for person in people {
        for own in logins(person) {
            let ends = places(name, own).filter(|at| *at > 0 && at + own.len() == name.len());
            found.extend(ends.map(|at| (&name[..at], &*person.id)));
        }
    }
    found
}

/// What stands after each login that begins a name, and the login's person.
fn titles_after<'a, 'n>(name: &'n str, people: &'a [Person]) -> BTreeSet<(&'n str, &'a str)> {
    let of = |person: &'a Person| {
        let logins = assigned(person).chain(chosen(person));
        let begins = logins.filter(|own| places(name, own).next() == Some(0));
        let rests = begins.map(|own| &name[own.len()..]);
        rests
            .filter(|rest| !rest.is_empty())
            .map(|rest| (rest, &*person.id))
            .collect::<Vec<_>>()
    };
    people.iter().flat_map(of).collect()
}

/// Titles, and the people beside whose logins they stand.
#[derive(Default)]
pub struct Titles(BTreeMap<String, BTreeSet<String>>);

impl Titles {
    /// Adds the ways to read a name, if there is only one.
    pub fn add(&mut self, ways: &BTreeSet<(&str, &str)>) {
        let mut ways = ways.iter();
        if let (Some((title, person)), None) = (ways.next(), ways.next()) {
            let people = self.0.entry((*title).to_owned()).or_default();
            people.insert((*person).to_owned());
        }
    }

    /// Whether a title is a part of another that is more frequent, or contains one that is at least
    /// as frequent. Beside `HW1_ada`, the login in `HW1_x_bob` is not `bob`, but `x_bob`.
    pub fn is_doubtful(&self, title: &str, contains: fn(&str, &str) -> bool) -> bool {
        let people = |title: &str| self.0.get(title).map_or(0, BTreeSet::len);
        let own = people(title);
        let mut others = self.0.keys().filter(|other| *other != title);
        others.any(|other| {
            contains(other, title) && people(other) > own
                || contains(title, other) && people(other) >= own
        })
    }

    /// The titles that several people have, and that are not doubtful.
    fn certain(&self, contains: fn(&str, &str) -> bool) -> Vec<String> {
        let several = self.0.iter().filter(|(_, people)| people.len() > 1);
        let titles = several.map(|(title, _)| title);
        let certain = titles.filter(|title| !self.is_doubtful(title, contains));
        certain.cloned().collect()
    }
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
