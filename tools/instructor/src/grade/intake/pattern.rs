//! How the instructor says that folders and archives are named, such as `hw1-{github}`.

use std::fmt::{self, Display, Formatter};
use std::str::FromStr;

use serde::{Deserialize, Serialize};

use super::index::{Index, assigned, once};
use super::matching::{Proof, without_accents};
use super::names::{self, Platform, PlatformName, Sign};
use super::reader::file_names;
use super::roster::Person;

/// A text around what names a person.
#[derive(Clone, Debug, Deserialize, Eq, PartialEq, Serialize)]
#[serde(try_from = "String", into = "String")]
pub struct NamePattern {
    before: String,
    key: Key,
    after: String,
}

/// What names a person.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum Key {
    /// An id, or a login that the university assigned.
    Id,
    /// A login on GitHub. No two accounts have the same one, and logins that differ by a hyphen are
    /// different.
    GitHub,
    /// A group's name, perhaps as GitHub writes it in addresses.
    Group,
    /// A person's name, with the last name first or last.
    Name,
}

const KEYS: [(&str, Key); 4] = [
    ("{id}", Key::Id),
    ("{github}", Key::GitHub),
    ("{group}", Key::Group),
    ("{name}", Key::Name),
];

impl Default for NamePattern {
    fn default() -> NamePattern {
        NamePattern {
            before: String::new(),
            key: Key::Id,
            after: String::new(),
        }
    }
}

impl NamePattern {
    pub fn key(&self) -> Key {
        self.key
    }

    /// Whether a name has this pattern, and something around what names a person.
    pub fn fits(&self, name: &str) -> bool {
        let is_bare = self.before.is_empty() && self.after.is_empty();
        !is_bare && self.own(name).is_some_and(|own| !own.is_empty())
    }

    /// All ways to read a name as a platform's. What the instructor says of names outweighs these, but
    /// Blackboard adds a time and a file's name to it.
    pub fn readings<'n>(&self, name: &'n str, from: Option<Platform>) -> Vec<PlatformName<'n>> {
        let mut all = names::readings(name, from);
        let is_login = |it: &PlatformName| self.is_login(&it.sign());
        let is_said = self.gives(name) || all.iter().any(is_login);
        all.retain(|it| !is_said || is_login(it));
        all
    }

    /// Whether the instructor or GitHub gave this name. GitHub may have added another branch.
    fn gives(&self, name: &str) -> bool {
        let begins = !self.before.is_empty() && name.starts_with(&self.before);
        begins || self.fits(file_names::stem(name))
    }

    /// The platform that has exported files of these names. If one of them is a clone's, somebody may
    /// have named a branch like a platform's file.
    pub fn exported_by<'a>(&self, names: impl Iterator<Item = &'a String>) -> Option<Platform> {
        let mut has_clone = false;
        let read = names.map(|name| {
            let all = self.readings(name, None);
            has_clone |= self.key != Key::Id && all.is_empty() && self.gives(name);
            all
        });
        let platform = names::exported_by(read);
        platform.filter(|_| !has_clone)
    }

    /// Whether a sign may prove something because it comes from a platform. If the instructor has said
    /// how submissions are named, somebody may have named a branch like a platform's file.
    pub fn is_platforms(&self, sign: &Sign) -> bool {
        match sign {
            Sign::Plain(_) => false,
            _ => *self == NamePattern::default() || self.is_login(sign),
        }
    }

    /// Whether this is what Blackboard writes before the time, as the instructor has described it.
    pub fn is_login(&self, sign: &Sign) -> bool {
        matches!(sign, Sign::Login(text) if self.key == Key::Id && self.fits(text))
    }

    /// The part of a name that says whose it is, if the name has this pattern.
    pub fn own<'t>(&self, name: &'t str) -> Option<&'t str> {
        let rest = name.strip_prefix(&*self.before)?;
        rest.strip_suffix(&*self.after)
    }
}

impl Key {
    /// Whether a part of a name also stands for somebody together with what the instructor, the platform
    /// or a branch's author has added. GitHub and GitLab write hyphens around it.
    pub fn is_near(self, own: &str, index: &Index) -> bool {
        let within = format!("-{own}-").to_ascii_lowercase();
        let is_in = |text: &str| {
            text.len() < own.len() && within.contains(&format!("-{}-", text.to_ascii_lowercase()))
        };
        index.people.iter().any(|it| match self {
            Key::Id => assigned(it).any(is_in),
            Key::GitHub => it.github.as_deref().is_some_and(is_in),
            Key::Group | Key::Name => false,
        })
    }

    /// The people whom a part of a name stands for, and how much it proves if it is only one.
    pub fn owners<'a>(self, own: &str, index: &Index<'a>) -> (Proof, Vec<&'a Person>) {
        match self {
            Key::Id => {
                let assigned = index.with_assigned(own);
                // A login on GitHub may stand in for an id, and people may have typed in an address.
                let chosen = index.exactly(own, |it| [&*it.id].into_iter());
                match (assigned.is_empty(), chosen.is_empty()) {
                    (false, _) => (Proof::Id, assigned),
                    (_, false) => (Proof::Name, chosen),
                    _ => (Proof::Name, index.exactly(own, Person::addresses_in_full)),
                }
            }
            Key::GitHub => {
                let with = index.exactly(own, |it| it.github.as_deref().into_iter());
                (Proof::Id, with)
            }
            // People choose the names of their groups, and several may be written alike.
            Key::Group => {
                let all = index.people.iter();
                let found = all.filter(|it| it.group.as_ref().is_some_and(|it| is_group(it, own)));
                (Proof::Given, found.collect())
            }
            Key::Name => {
                let found = index.whole(own).filter(|(_, kind)| kind.is_name());
                (Proof::Name, once(found.map(|(person, _)| person)))
            }
        }
    }
}

/// Whether this is a group's name, perhaps as GitHub writes it in addresses.
fn is_group(group: &str, own: &str) -> bool {
    let own = own.to_lowercase();
    let ways = [in_address(group), in_address(&without_accents(group))];
    !own.is_empty() && (group.to_lowercase() == own || ways.contains(&own.replace('_', "-")))
}

/// A name without the letters that aren't ASCII, and with hyphens between its words.
fn in_address(name: &str) -> String {
    let name = name.to_lowercase();
    let words = name.split(|c: char| !c.is_ascii_alphanumeric());
    let words: Vec<&str> = words.filter(|it| !it.is_empty()).collect();
    words.join("-")
}

impl FromStr for NamePattern {
    type Err = String;

    fn from_str(text: &str) -> Result<NamePattern, String> {
        if file_names::is_archive(text) {
            return Err("leave out the ending of archives".into());
        }
        let found =
            KEYS.map(|(word, key)| text.match_indices(word).map(move |(at, _)| (at, word, key)));
        let mut found = found.into_iter().flatten();
        let (Some((at, word, key)), None) = (found.next(), found.next()) else {
            let all = KEYS.map(|(word, _)| word).join(" or ");
            return Err(format!(
                "it must contain {all} exactly once, as in hw1-{{github}}"
            ));
        };
        Ok(NamePattern {
            before: text[..at].to_owned(),
            key,
            after: text[at + word.len()..].to_owned(),
        })
    }
}

impl Display for NamePattern {
    fn fmt(&self, formatter: &mut Formatter) -> fmt::Result {
        let mut words = KEYS.iter();
        let word = words
            .find(|(_, key)| *key == self.key)
            .map(|(word, _)| word);
        let word = word.expect("each key has a word");
        write!(formatter, "{}{word}{}", self.before, self.after)
    }
}

impl TryFrom<String> for NamePattern {
    type Error = String;

    fn try_from(text: String) -> Result<NamePattern, String> {
        text.parse()
    }
}

impl From<NamePattern> for String {
    fn from(pattern: NamePattern) -> String {
        pattern.to_string()
    }
}

#[cfg(test)]
mod tests {
    use super::super::placement::tests::person;
    use super::*;

    #[test]
    fn a_pattern_names_one_key() {
        for text in [
            "{id}",
            "hw1-{github}",
            "{id}_hw1",
            "hw1-{group}-main",
            "{name}",
            "{{id}}",
        ] {
            let pattern: NamePattern = text.parse().expect(text);
            assert_eq!(pattern.to_string(), text);
        }
        for text in ["", "hw1-", "{login}", "{id}{id}", "{id}-{github}", "{ID}"] {
            let why = text.parse::<NamePattern>().expect_err(text);
            assert!(
                why.contains("{id} or {github} or {group} or {name}"),
                "{why}"
            );
        }
    }

    #[test]
    fn a_name_must_have_exactly_the_pattern_and_the_key() {
        let people = ["ada", "a-da", "hw1-ada", "ada-main"].map(|login| Person {
            github: Some(login.into()),
            ..person(&format!("id of {login}"), "Eve")
        });
        let owners = |pattern: &str, name: &str| -> Vec<String> {
            let pattern: NamePattern = pattern.parse().expect("it is a pattern");
            let own = pattern.own(name).unwrap_or_default();
            let (_, found) = pattern.key.owners(own, &Index::of(&people));
            found.iter().filter_map(|it| it.github.clone()).collect()
        };
        for (pattern, name, owner) in [
            ("hw1-{github}", "hw1-ada", &["ada"][..]),
            ("hw1-{github}", "hw1-ADA", &["ada"]),
            ("hw1-{github}", "hw1-a-da", &["a-da"]),
            ("hw1-{github}", "hw1-hw1-ada", &["hw1-ada"]),
            ("hw1-{github}", "hw1-ada-main", &["ada-main"]),
            ("hw1-{github}-main", "hw1-ada-main", &["ada"]),
            ("{github}", "hw1-ada", &["hw1-ada"]),
            ("hw1-{github}", "hw2-ada", &[]),
            ("hw1-{github}", "hw1-ad", &[]),
            ("hw1-{github}", "hw1-", &[]),
            ("hw1-{id}", "hw1-ada", &[]),
            ("hw1-{group}", "hw1-ada", &[]),
        ] {
            assert_eq!(owners(pattern, name), owner, "{pattern} {name}");
        }
    }

    #[test]
    fn groups_are_found_however_github_writes_them() {
        let groups = ["Röckets", "First Team", "7", "My_Team X"];
        let people = groups.map(|group| Person {
            group: Some(group.into()),
            ..person(group, "Eve")
        });
        for (own, group) in [
            ("r-ckets", "Röckets"),
            ("rockets", "Röckets"),
            ("first-team", "First Team"),
            ("First Team", "First Team"),
            ("my_team-x", "My_Team X"),
            ("7", "7"),
        ] {
            let (proof, found) = Key::Group.owners(own, &Index::of(&people));
            assert_eq!(found.len(), 1, "{own}");
            assert_eq!((proof, &*found[0].id), (Proof::Given, group));
        }
    }
}
