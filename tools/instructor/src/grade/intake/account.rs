//! Whose submission it is, by what a platform wrote into its name.

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

/// The people whose id, login or address may end what Blackboard writes: the assignment's title, `_`,
/// and a login. A title and a login may contain `_`, so this proves nothing: somebody else's login may be
/// `stud_ada`.
pub fn with_login<'a>(text: &str, index: &Index<'a>) -> (Proof, Vec<&'a Person>) {
    let ends = text.match_indices('_').map(|(at, _)| &text[at + 1..]);
    let ends: Vec<&str> = ends.collect();
    let found = ends.iter().flat_map(|end| Key::Id.owners(end, index).1);
    let found = once(found);
    if !found.is_empty() {
        return (Proof::Name, found);
    }
    let is_end = |own: &str| ends.iter().any(|end| own.eq_ignore_ascii_case(end));
    let has = |it: &&Person| it.addresses().any(is_end);
    (Proof::Hint, index.people.iter().filter(has).collect())
}
