//! Whose submission it is, by what a platform wrote into its name.

use std::cmp::Reverse;
use std::collections::BTreeSet;

use super::index::{Index, once, words};
use super::matching::{Proof, is_group, unaccented};
use super::pattern::Key;
use super::roster::Person;

/// The people that an account may belong to. The platform's number decides, because people may
/// change their names, unless the number may be a group's. If the number stands beside a name that
/// isn't the person's, the instructor should check it, because the author of an archive may have
/// chosen both. A group's name proves nothing, because somebody else may have this name.
pub fn with_account<'a>(
    number: &str,
    name: &str,
    may_be_group: bool,
    index: &Index<'a>,
) -> (Proof, Vec<&'a Person>) {
    let with_number = index.people.iter();
    let with_number = with_number.filter(|it| it.number.as_deref() == Some(number));
    let with_number: Vec<&Person> = with_number.take(1).collect();
    // People may have chosen an address like somebody's name.
    let named = index.whole(name).filter(|(_, kind)| kind.is_name());
    let named = once(named.map(|(person, _)| person));
    let in_group = index.people.iter();
    let in_group = in_group.filter(|it| may_be_group && is_group(name, it));
    let in_group: Vec<&Person> = in_group.collect();
    if let [person] = with_number[..] {
        let is_named = named.contains(&person) && !in_group.contains(&person);
        let proof = match (is_named, may_be_group) {
            (true, _) if in_group.is_empty() => Proof::Id,
            (true, _) => Proof::Given,
            _ if !in_group.is_empty() => Proof::Hint,
            (_, false) if share_word(name, &person.name) => Proof::Id,
            (_, false) => Proof::Given,
            (_, true) if share_word(name, &person.name) => Proof::Name,
            (_, true) => Proof::Hint,
        };
        let others = in_group.into_iter().filter(|_| !is_named);
        return (proof, once(with_number.into_iter().chain(others)));
    }
    if !in_group.is_empty() {
        return (Proof::Hint, once(in_group.into_iter().chain(named)));
    }
    let is_free = |it: &&Person| it.number.is_none();
    let named: Vec<&Person> = named.into_iter().filter(is_free).collect();
    // A number in a name may equal somebody else's id by chance.
    let by_id = index.people.iter().filter(is_free);
    let by_id: Vec<&Person> = by_id.filter(|it| it.id == number).collect();
    let agrees = |it: &&Person| by_id.is_empty() || by_id.contains(it);
    match named.iter().copied().filter(agrees).collect::<Vec<_>>() {
        both if both.is_empty() => (Proof::Hint, [named, by_id].concat()),
        both => (Proof::Name, both),
    }
}

/// Whether two names have a word in common.
fn share_word(name: &str, other: &str) -> bool {
    let folded = |text: &str| -> Vec<String> {
        let words = words(text).into_iter();
        words.map(|at| unaccented(&text[at])).collect()
    };
    let others = folded(other);
    folded(name).iter().any(|word| others.contains(word))
}

/// The title that Blackboard writes before logins, with the `_` after it. All of these names begin with
/// it, and no other beginning leaves the id or login of more people. All logins may begin alike, too, so
/// the shortest such beginning is the title.
pub fn title(names: &BTreeSet<&str>, index: &Index) -> String {
    let Some(first) = names.first() else {
        return String::new();
    };
    let titles = starts(first).map(|start| &first[..start]);
    let known = |title: &str| {
        let logins = names.iter().map(|name| name.strip_prefix(title));
        let logins: Option<Vec<&str>> = logins.collect();
        let is_known = |login: &&str| !index.with_assigned(login).is_empty();
        logins.map_or(0, |all| all.into_iter().filter(is_known).count())
    };
    let titles = titles.map(|title| (known(title), Reverse(title.len()), title));
    let best = titles.filter(|(known, ..)| *known > 1).max();
    best.map_or_else(String::new, |(.., title)| title.to_owned())
}

/// Where a login may begin in what Blackboard writes.
fn starts(text: &str) -> impl Iterator<Item = usize> {
    text.match_indices('_').map(|(at, _)| at + 1)
}

/// Whether after another title than this one, the id or login of somebody else is left.
fn may_be_anothers(text: &str, title: &str, index: &Index) -> bool {
    let own = index.with_assigned(&text[title.len()..]);
    let mut others = starts(text).flat_map(|at| index.with_assigned(&text[at..]));
    others.any(|it| !own.contains(&it))
}

/// The people whose login ends what Blackboard writes: the assignment's title, `_`, and a login. A
/// login may contain `_`, so it proves something only after the `title` of all submissions. People may
/// have typed in their addresses, so these suggest somebody at most.
pub fn with_login<'a>(text: &str, title: &str, index: &Index<'a>) -> (Proof, Vec<&'a Person>) {
    let has_title = !title.is_empty() && text.starts_with(title);
    let is_possible = |start: &usize| !has_title || *start == title.len();
    let starts: Vec<usize> = starts(text).filter(is_possible).collect();
    let mut all_agree = match has_title {
        // Perhaps the title is another.
        true if may_be_anothers(text, title, index) => Proof::Given,
        true => Proof::Id,
        false => Proof::Name,
    };
    let mut found: Vec<&Person> = Vec::new();
    for at in &starts {
        let (proof, people) = Key::Id.owners(&text[*at..], index);
        if !people.is_empty() {
            all_agree = all_agree.min(proof);
        }
        found.extend(people);
    }
    if found.is_empty() {
        let is_end = |own: &str| {
            starts
                .iter()
                .any(|at| own.eq_ignore_ascii_case(&text[*at..]))
        };
        let has = |it: &&Person| it.addresses().any(is_end);
        return (Proof::Hint, index.people.iter().filter(has).collect());
    }
    (all_agree, once(found))
}
