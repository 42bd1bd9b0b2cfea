//! Finds the people whose id, login, name or group stands in a text.

use std::collections::HashMap;
use std::ops::Range;

use unicode_normalization::char::is_combining_mark;

use super::matching::{ascii, folded, has_chosen_id, turned, unaccented};
use super::roster::Person;

/// What a text is of a person.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum Kind {
    /// An id or a login that the university assigned.
    Assigned,
    /// A login on GitHub, an e-mail address, its beginning, or a group's name. People may have chosen
    /// it.
    Chosen,
    /// A display name of several words.
    Name,
    /// A name of one word, or one that has lost letters. It counts only if it stands alone.
    LoneName,
    /// A group's number. It counts only if it stands alone.
    LoneGroup,
}

/// A part of a text that stands for a person.
#[derive(Clone, Debug)]
pub struct Match<'a> {
    pub person: &'a Person,
    pub kind: Kind,
    /// Its place in the text, from the first letter or digit to the last.
    pub at: Range<usize>,
}

impl Kind {
    pub fn is_name(self) -> bool {
        matches!(self, Kind::Name | Kind::LoneName)
    }

    /// Whether it counts only if it stands alone.
    pub fn is_lone(self) -> bool {
        matches!(self, Kind::LoneName | Kind::LoneGroup)
    }
}

impl Match<'_> {
    /// Whether no letter or digit of this text is outside of the match.
    pub fn is_all_of(&self, text: &str) -> bool {
        let outside = [&text[..self.at.start], &text[self.at.end..]];
        !outside.concat().contains(char::is_alphanumeric)
    }
}

/// People by what stands for them, without punctuation.
#[derive(Default)]
pub struct Index<'a> {
    pub people: &'a [Person],
    by_text: HashMap<String, Vec<(usize, Kind)>>,
    /// The length of the longest of these texts, in bytes.
    longest: usize,
}

impl<'a> Index<'a> {
    pub fn of(people: &'a [Person]) -> Index<'a> {
        let mut index = Index {
            people,
            by_text: HashMap::new(),
            longest: 0,
        };
        for (at, person) in people.iter().enumerate() {
            for own in assigned(person) {
                index.add(at, Kind::Assigned, own);
            }
            for own in chosen(person) {
                // Browsers add numbers to the names of files.
                let is_number = own.bytes().all(|it| it.is_ascii_digit());
                let is_group = person.group.as_deref() == Some(own);
                let kind = match is_number && is_group {
                    true => Kind::LoneGroup,
                    false => Kind::Chosen,
                };
                // GitHub drops the letters of a team's name that aren't ASCII.
                for own in [own, &ascii(own)] {
                    index.add(at, kind, own);
                }
            }
            let is_long = person.name.split_whitespace().count() > 1;
            let kind = if is_long { Kind::Name } else { Kind::LoneName };
            for own in turned(&person.name, folded) {
                index.add(at, kind, &own);
            }
            for own in turned(&person.name, ascii) {
                index.add(at, Kind::LoneName, &own);
            }
        }
        index
    }

    fn add(&mut self, at: usize, kind: Kind, text: &str) {
        for text in [folded(text), unaccented(text)] {
            // Somebody may have chosen a name that is longer than any folder's.
            self.longest = self.longest.max(text.len().min(255));
            if !text.is_empty() {
                self.by_text.entry(text).or_default().push((at, kind));
            }
        }
    }

    /// Everyone who stands in a text as one or several whole words.
    pub fn find(&self, text: &str) -> Vec<Match<'a>> {
        let words = words(text);
        let mut found = Vec::new();
        let both = |at: &Range<usize>| (folded(&text[at.clone()]), unaccented(&text[at.clone()]));
        let both: Vec<_> = words.iter().map(both).collect();
        for first in 0..words.len() {
            let [mut own, mut plain] = [String::new(), String::new()];
            for last in first..words.len() {
                own += &both[last].0;
                plain += &both[last].1;
                if plain.len() > self.longest && own.len() > self.longest {
                    break;
                }
                let all = self.with(&own, &plain);
                found.extend(all.map(|(person, kind)| Match {
                    person,
                    kind,
                    at: words[first].start..words[last].end,
                }));
            }
        }
        found
    }

    /// Everyone for whom exactly this text stands, apart from the case of letters, each once.
    /// `own` says what somebody's texts are.
    pub fn exactly<I: Iterator<Item = &'a str>>(
        &self,
        text: &str,
        own: impl Fn(&'a Person) -> I,
    ) -> Vec<&'a Person> {
        let all = self.by_text.get(&folded(text)).into_iter().flatten();
        let all = once(all.map(|(at, _)| &self.people[*at])).into_iter();
        all.filter(|it| own(it).any(|own| own.eq_ignore_ascii_case(text)))
            .collect()
    }

    /// The people with this id or login, as the university assigned them.
    pub fn with_assigned(&self, id: &str) -> Vec<&'a Person> {
        self.exactly(id, assigned)
    }

    /// Everyone whom a whole text stands for.
    pub fn whole<'s>(
        &'s self,
        text: &str,
    ) -> impl Iterator<Item = (&'a Person, Kind)> + use<'s, 'a> {
        self.with(&folded(text), &unaccented(text))
    }

    /// Everyone with this text. A name has lost its accents only if nobody's has them.
    fn with<'s>(
        &'s self,
        own: &str,
        unaccented: &str,
    ) -> impl Iterator<Item = (&'a Person, Kind)> + use<'s, 'a> {
        let of = |text| self.by_text.get(text).map_or(&[][..], Vec::as_slice);
        let exact = of(own);
        let is_name = exact.iter().any(|(_, kind)| kind.is_name());
        let near = match is_name || own == unaccented {
            true => &[],
            false => of(unaccented),
        };
        let all = exact.iter().chain(near);
        all.map(|(at, kind)| (&self.people[*at], *kind))
    }
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

/// The id and the logins of a person, as the university assigned them.
pub fn assigned(person: &Person) -> impl Iterator<Item = &str> {
    let id = (!has_chosen_id(person)).then_some(&person.id);
    id.into_iter()
        .chain(person.assigned_logins())
        .map(String::as_str)
}

/// What a person may have chosen: a login on GitHub, addresses and their beginnings, and the name of
/// a group.
fn chosen(person: &Person) -> impl Iterator<Item = &str> {
    let others = person.github.iter().chain(&person.group);
    person.addresses().chain(others.map(String::as_str))
}

/// The places of the words of a text. In an archive, a name may have thousands; the first are
/// enough, because the names of folders are shorter.
pub fn words(text: &str) -> Vec<Range<usize>> {
    const MOST: usize = 64;
    let is_letter = |c: char| c.is_alphanumeric() || is_combining_mark(c);
    let words = text.split(|c| !is_letter(c));
    let at = |word: &str| word.as_ptr() as usize - text.as_ptr() as usize;
    let places = words.map(|word| at(word)..at(word) + word.len());
    let places = places.filter(|it| text[it.clone()].contains(char::is_alphanumeric));
    places.take(MOST).collect()
}
