//! Compares names, logins and numbers with those of people on the roster.

use serde::{Deserialize, Serialize};
use unicode_normalization::UnicodeNormalization;
use unicode_normalization::char::is_combining_mark;

use super::roster::Person;

/// The letters and digits of a text in lower case, with accents composed. A backtick, which names of
/// files write as in URLs (see [`pinhole_course::submission::text::name`]), is none.
pub fn folded(text: &str) -> String {
    let composed: String = text.replace("%60", "`").nfc().collect();
    let kept = composed.chars().filter(|c| c.is_alphanumeric());
    kept.flat_map(char::to_lowercase).collect()
}

/// The letters and digits of a text in lower case, without accents.
pub fn unaccented(text: &str) -> String {
    folded(&without_accents(text))
}

/// A text without accents.
pub fn without_accents(text: &str) -> String {
    text.nfkd().filter(|c| !is_combining_mark(*c)).collect()
}

/// The same, without the letters that have accents. Canvas drops them from names.
pub fn ascii(text: &str) -> String {
    folded(text).chars().filter(char::is_ascii).collect()
}

/// The ways to write a name in one word, with the last name first or last. No last name begins
/// after more words than [`MOST_FIRST_NAMES`].
pub fn turned(name: &str, fold: fn(&str) -> String) -> Vec<String> {
    let words: Vec<String> = name
        .split(|c: char| c.is_whitespace() || c == ',')
        .map(fold)
        .filter(|word| !word.is_empty())
        .collect();
    let turned = |k: usize| [&words[k..], &words[..k]].concat().concat();
    (0..words.len().min(MOST_FIRST_NAMES)).map(turned).collect()
}

/// Somebody may have chosen a name of hundreds of words, and comparing it in each order takes long.
const MOST_FIRST_NAMES: usize = 16;

/// Whether this is a person's name, with the last name first or last.
pub fn is_name(name: &str, person: &Person) -> bool {
    let ways = turned(&person.name, folded);
    turned(name, folded)
        .first()
        .is_some_and(|name| ways.contains(name))
}

/// Whether this is the name of the person's group.
pub fn is_group(name: &str, person: &Person) -> bool {
    let group = person.group.as_deref().map(folded);
    group.is_some_and(|it| !it.is_empty() && it == folded(name))
}

/// Whether a number that a platform wrote beside this name is the person's. If it may be a group's
/// number, the name must be the person's too, and not the group's, because somebody else may have the
/// same number.
pub fn is_own_number(number: &str, name: &str, may_be_group: bool, person: &Person) -> bool {
    let is_named = is_name(name, person) && !is_group(name, person);
    !may_be_group || person.number.as_deref() == Some(number) || is_named
}

/// How well a sign proves who handed something in.
#[derive(Clone, Copy, Debug, Default, Deserialize, Eq, Ord, PartialEq, PartialOrd, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Proof {
    /// It only suggests a person.
    Hint,
    /// A name or a login that people may have chosen themselves.
    Name,
    /// An id or a login, but the instructor should check it.
    Given,
    /// A number or a login that the platform gave, or a name that the instructor gave.
    #[default]
    Id,
}

/// Whether a login on GitHub, which people choose themselves, stands in for a person's id.
pub fn has_chosen_id(person: &Person) -> bool {
    let github = person.github.as_ref();
    github.is_some_and(|it| it.eq_ignore_ascii_case(&person.id))
}

/// Whether somebody else has this login or id, too. People choose their logins on GitHub.
pub fn is_anothers_login(login: &str, person: &Person, people: &[Person]) -> bool {
    let others = people.iter().filter(|other| other.id != person.id);
    let mut logins = others.flat_map(|other| other.all_logins().chain([&other.id]));
    logins.any(|own| own.eq_ignore_ascii_case(login))
}
