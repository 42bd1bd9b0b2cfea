//! Compares names, logins and numbers with those of people on the roster.

use serde::{Deserialize, Serialize};
use unicode_normalization::UnicodeNormalization;
use unicode_normalization::char::is_combining_mark;

use super::names::Sign;
use super::roster::Person;

/// The letters and digits of a text in lower case, with accents composed.
pub fn folded(text: &str) -> String {
    let composed: String = text.nfc().collect();
    let kept = composed.chars().filter(|c| c.is_alphanumeric());
    kept.flat_map(char::to_lowercase).collect()
}

/// Whether [`folded`] turns a text into this one. ASCII text is not copied for this, because every
/// submission is compared with everyone on the roster.
pub fn is_folded(folded_text: &str, text: &str) -> bool {
    let plain = text.bytes().filter(u8::is_ascii_alphanumeric);
    match text.is_ascii() {
        true => plain
            .map(|c| c.to_ascii_lowercase())
            .eq(folded_text.bytes()),
        false => folded(text) == folded_text,
    }
}

/// A text without accents.
pub fn without_accents(text: &str) -> String {
    text.nfkd().filter(|c| !is_combining_mark(*c)).collect()
}

/// The letters and digits of a text in lower case, without accents.
fn unaccented(text: &str) -> String {
    folded(&without_accents(text))
}

/// The ways to write a name in one word, with the last name first or last. No last name begins
/// after more words than [`MOST_FIRST_NAMES`].
fn turned(name: &str, fold: &dyn Fn(&str) -> String) -> Vec<String> {
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

/// A person's name in one word, in every order and with and without accents.
pub fn spellings(name: &str) -> Vec<String> {
    let ascii = |text: &str| -> String { folded(text).chars().filter(char::is_ascii).collect() };
    let folds: [&dyn Fn(&str) -> String; 3] = [&folded, &unaccented, &ascii];
    folds
        .into_iter()
        .flat_map(|fold| turned(name, fold))
        .collect()
}

/// The people with this name. Platforms keep accents, drop them, or drop the letters that have
/// them. So letters of the roster's name may be missing in this one. But if this one has a letter
/// that the roster's lacks, it is somebody else's.
pub fn named<'a>(name: &str, people: &'a [Person]) -> Vec<&'a Person> {
    let ascii = |text: &str| -> String { folded(text).chars().filter(char::is_ascii).collect() };
    type Fold<'f> = &'f dyn Fn(&str) -> String;
    // A name without accents may be somebody's who has none, or has lost them.
    let folds: [(Fold<'_>, Fold<'_>); 4] = [
        (&folded, &unaccented),
        (&folded, &folded),
        (&unaccented, &unaccented),
        (&folded, &ascii),
    ];
    let found = folds.iter().map(|(fold, fold_roster)| {
        let person = fold(name);
        // An uploader can make a name that can be read in a hundred ways, and each is compared with
        // everyone. So first compare lengths, which copies nothing.
        let is_as_long = |other: &str| {
            let letters = other.bytes().filter(u8::is_ascii_alphanumeric);
            !other.is_ascii() || letters.count() == person.len()
        };
        let is = |other: &&Person| {
            is_as_long(&other.name) && turned(&other.name, fold_roster).contains(&person)
        };
        people.iter().filter(is).collect::<Vec<_>>()
    });
    found
        .into_iter()
        .find(|found| !found.is_empty())
        .unwrap_or_default()
}

/// Whether this is a person's name, with the last name first or last.
pub fn is_name(name: &str, person: &Person) -> bool {
    let ways = turned(&person.name, &folded);
    turned(name, &folded)
        .first()
        .is_some_and(|name| ways.contains(name))
}

/// Whether a number that a platform wrote beside this name is the person's. If it may be a group's
/// number, the name must be the person's too, because somebody else may have the same number.
pub fn is_own_number(number: &str, name: &str, may_be_group: bool, person: &Person) -> bool {
    !may_be_group || person.number.as_deref() == Some(number) || is_name(name, person)
}

/// How well a sign proves who handed something in.
#[derive(Clone, Copy, Debug, Default, Deserialize, Eq, Ord, PartialEq, PartialOrd, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Proof {
    /// It only suggests a person.
    Hint,
    /// A name or a login that people may have chosen themselves.
    Name,
    /// A number or a login that the platform gave, or a name that the instructor gave.
    #[default]
    Id,
}

/// Whether the university assigned a person's id. A login on GitHub may stand in for one.
pub fn has_assigned_id(person: &Person) -> bool {
    person.github.as_ref() != Some(&person.id)
}

/// The people with this id or login, as the university assigned them. Only if nobody has it, those
/// whose id or login has the same letters and digits. Unless it is an id, nobody knows whether
/// people who have chosen it on GitHub, or for their group, are meant instead.
pub fn with_id<'a>(id: &str, people: &'a [Person]) -> Vec<&'a Person> {
    let with = |is: &dyn Fn(&String) -> bool| -> Vec<&'a Person> {
        let whole = |person: &&Person| {
            has_assigned_id(person) && is(&person.id) || person.logins.iter().any(is)
        };
        people.iter().filter(whole).collect()
    };
    let is_same = |own: &String| own.eq_ignore_ascii_case(id);
    let mut found = with(&is_same);
    let is_exact = !found.is_empty();
    if !is_exact {
        let id = folded(id);
        found = with(&|own| !id.is_empty() && is_folded(&id, own));
    }
    let has_this_id = |person: &&Person| has_assigned_id(person) && is_same(&person.id);
    if !found.is_empty() && !found.iter().any(has_this_id) {
        // A name that is only alike puts in doubt only what is itself only alike.
        let is_contested = |it: &&Person| {
            let is_theirs = !is_exact || it.group.as_ref().is_some_and(is_same);
            is_theirs && found.iter().all(|own| own.group != it.group)
        };
        let on_github = people.iter().filter(|it| has_github(it, id));
        let in_group = calling_themselves(id, people, |it| it.group.as_ref());
        let chosen = on_github.chain(in_group.filter(is_contested));
        let chosen: Vec<_> = chosen.filter(|it| !found.contains(it)).collect();
        found.extend(chosen);
    }
    found
}

/// The people whose e-mail address begins like this, or who have this login on GitHub instead of an
/// id. They may have chosen them.
pub fn with_chosen_login<'a>(login: &str, people: &'a [Person]) -> Vec<&'a Person> {
    let login = folded(login);
    let is = |text: &str| !login.is_empty() && is_folded(&login, text);
    let has = |person: &&Person| {
        let mut logins = person.logins.iter();
        logins.any(|it| it.split_once('@').is_some_and(|(local, _)| is(local)))
            || !has_assigned_id(person) && is(&person.id)
    };
    people.iter().filter(has).collect()
}

/// The people with this id or login or, if there are none, those who may have chosen it.
fn with_any_login<'a>(login: &str, people: &'a [Person]) -> Vec<&'a Person> {
    let found = with_id(login, people);
    match found.is_empty() {
        true => with_chosen_login(login, people),
        false => found,
    }
}

/// The people who have chosen this name for themselves or for their groups.
pub fn calling_themselves<'a>(
    name: &str,
    people: &'a [Person],
    of: fn(&Person) -> Option<&String>,
) -> impl Iterator<Item = &'a Person> {
    let name = folded(name);
    let is = move |own: &String| !name.is_empty() && is_folded(&name, own);
    people.iter().filter(move |it| of(it).is_some_and(&is))
}

/// Whether this is the id or the login that the university gave to somebody.
pub fn is_id(name: &str, people: &[Person]) -> bool {
    let is = |own: &String| own.eq_ignore_ascii_case(name);
    let mut people = people.iter();
    people.any(|it| has_assigned_id(it) && is(&it.id) || it.logins.iter().any(is))
}

/// Whether this is such an id or login, or has the same letters and digits as one.
pub fn is_like_id(name: &str, people: &[Person]) -> bool {
    !with_id(name, people).is_empty()
}

/// Whether somebody else has this login or id, too. People choose their logins on GitHub.
pub fn is_anothers_login(login: &str, person: &Person, people: &[Person]) -> bool {
    let others = people.iter().filter(|other| other.id != person.id);
    let mut logins = others.flat_map(|other| other.all_logins().chain([&other.id]));
    logins.any(|own| own.eq_ignore_ascii_case(login))
}

/// The people whose login ends what Blackboard writes, each with the title before the login.
pub fn titled<'a, 't>(sign: &'t Sign, people: &'a [Person]) -> Vec<(&'t str, &'a Person)> {
    let Sign::Login(text) = sign else {
        return Vec::new();
    };
    let ends = text.match_indices('_').map(|(at, _)| at + 1);
    let of = |at: usize| {
        let own = people.iter().filter(move |it| has_login(it, &text[at..]));
        own.map(move |person| (&text[..at], person))
    };
    ends.flat_map(of).collect()
}

fn has_login(person: &Person, login: &str) -> bool {
    let whole = person.logins.iter().map(String::as_str);
    let local = whole.clone().filter_map(|login| login.split('@').next());
    let mut all = whole.chain(local).chain([person.id.as_str()]);
    all.any(|own| own.eq_ignore_ascii_case(login))
}

fn has_github(person: &Person, login: &str) -> bool {
    let own = person.github.as_deref();
    own.is_some_and(|own| own.eq_ignore_ascii_case(login))
}

/// The words of a text, folded.
pub fn words(text: &str) -> Vec<String> {
    let words = text.split(|c: char| !c.is_alphanumeric() && !is_combining_mark(c));
    words.map(folded).filter(|word| !word.is_empty()).collect()
}

/// The people whose name is among a text's words, as in `homework1-adalovelace`.
pub fn named_among<'a>(text: &str, people: &'a [Person]) -> Vec<&'a Person> {
    let words = words(text);
    let whole = words.concat();
    let mut places = vec![0];
    for word in &words {
        places.push(places[places.len() - 1] + word.len());
    }
    let is_there = |other: &&Person| {
        let begins = |at: usize, name: &str| {
            whole[at..].starts_with(name) && places.binary_search(&(at + name.len())).is_ok()
        };
        let names = turned(&other.name, &folded);
        let mut places = places.iter();
        places.any(|at| names.iter().any(|name| begins(*at, name)))
    };
    let have_two_words = |other: &&Person| other.name.split_whitespace().count() > 1;
    people
        .iter()
        .filter(have_two_words)
        .filter(is_there)
        .collect()
}

/// Whether two names have a word in common.
fn share_word(name: &str, other: &str) -> bool {
    let words = |text: &str| -> Vec<String> {
        let words = text.split(|c: char| !c.is_alphanumeric() && !is_combining_mark(c));
        words.map(unaccented).filter(|it| !it.is_empty()).collect()
    };
    let others = words(other);
    words(name).iter().any(|word| others.contains(word))
}

/// The people that an account may belong to. The platform's number decides, because people may
/// change their names, unless the number may be a group's. If the number stands beside a name that
/// isn't the person's, the instructor should check it, because the author of an archive may have
/// chosen both.
pub fn account<'a>(
    number: &str,
    name: &str,
    may_be_group: bool,
    people: &'a [Person],
) -> (Proof, Vec<&'a Person>) {
    let own = |other: &&Person| other.number.as_deref() == Some(number);
    let mut of_group = calling_themselves(name, people, |it| it.group.as_ref());
    if let Some(person) = people.iter().find(own) {
        let is_named = !named(name, std::slice::from_ref(person)).is_empty();
        let is_like = is_named || share_word(name, &person.name);
        let proof = match (is_like, may_be_group) {
            (true, false) => Proof::Id,
            (true, true) if is_named => Proof::Id,
            (false, true) => Proof::Hint,
            _ => Proof::Name,
        };
        // A group's name may have a word in common with the person whose number it has.
        let of_group = of_group.find(|_| may_be_group && !is_named);
        return (proof, [person].into_iter().chain(of_group).collect());
    }
    let mut by_name = named(name, people);
    by_name.extend(with_any_login(name, people));
    by_name.retain(|other| other.number.is_none());
    // On Moodle, the number is the group's.
    by_name.extend(of_group.filter(|it| may_be_group || it.number.is_none()));
    // A number in a name may equal somebody else's id by chance.
    let is_id = |other: &&Person| other.number.is_none() && other.id == number;
    let by_id: Vec<&Person> = people.iter().filter(is_id).collect();
    let agrees = |other: &&Person| by_id.is_empty() || by_id.contains(other);
    match by_name.iter().copied().filter(agrees).collect::<Vec<_>>() {
        both if both.is_empty() => (Proof::Hint, [by_name, by_id].concat()),
        both => (Proof::Name, both),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn is_folded_agrees_with_folded() {
        for text in ["Ada.Lovelace@x.org", "a_1", "", "Zoë", "İpek", "e\u{301}"] {
            assert!(is_folded(&folded(text), text), "{text}");
            assert!(!is_folded("somebody else", text), "{text}");
        }
    }
}
