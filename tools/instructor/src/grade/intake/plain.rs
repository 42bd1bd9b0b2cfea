//! Whose submission a folder or an archive is, by its name.
//!
//! The university assigns ids and logins. People choose their logins on GitHub, the names of their
//! groups, and often addresses and display names, perhaps so that they look like somebody else's.
//! So only an id, or the part of a name that the instructor has shown by a [`NamePattern`], says whose
//! a submission is. People who merely stand in a name are suggested to the instructor.

use super::index::{Index, Kind, Match, once};
use super::matching::Proof;
use super::pattern::{Key, NamePattern};
use super::roster::Person;

/// The people that a name may mean, each once, and how much it proves if it means only one.
pub fn meant<'a>(name: &str, named: &NamePattern, index: &Index<'a>) -> (Proof, Vec<&'a Person>) {
    let (own, key) = part(name, named);
    let (proof, found) = key.owners(own, index);
    if found.is_empty() {
        return (Proof::Hint, suggested(own, index));
    }
    // The whole name may be an id, too.
    let by_id = index.with_assigned(name);
    let both = once(found.iter().copied().chain(by_id));
    // In place of an id, it may be a login and a branch, between which GitHub writes a hyphen.
    let is_clone = named.own(name).is_none() && name.contains('-');
    let most = if is_clone { Proof::Given } else { Proof::Id };
    match both == found {
        true => (proof.min(most), found),
        false => (Proof::Hint, both),
    }
}

/// Whether a group's name, or another person's id or login, may stand in the name of a clone. If no
/// pattern is given, folders are named after ids, and hold nothing else.
pub fn may_be_anothers(name: &str, named: &NamePattern, index: &Index) -> bool {
    let (own, key) = part(name, named);
    let is_group = || key == Key::GitHub && !Key::Group.owners(own, index).1.is_empty();
    *named != NamePattern::default() && (key.is_near(own, index) || is_group())
}

/// The people who stand in a part of a name.
fn suggested<'a>(own: &str, index: &Index<'a>) -> Vec<&'a Person> {
    let all = index.find(own).into_iter();
    let all = all.filter(|it| !it.kind.is_lone() || it.is_all_of(own));
    once(all.map(|it| it.person))
}

/// Whether others have chosen a text that is this person's id or login. If the text names a folder,
/// they may be meant.
pub fn is_contested(name: &str, person: &Person, named: &NamePattern, index: &Index) -> bool {
    let (own, key) = part(name, named);
    key == Key::Id && index.whole(own).any(|(it, _)| it != person)
}

/// Whether a name says whose a submission is.
pub fn has_owner(name: &str, named: &NamePattern, index: &Index) -> bool {
    let (own, key) = part(name, named);
    !key.owners(own, index).1.is_empty()
}

/// Whether somebody stands in the name of a folder who doesn't own the clone around it. Folders that
/// are named after ids may hold any names.
pub fn names_another(inside: &str, clone: &str, named: &NamePattern, index: &Index) -> bool {
    let (own, key) = part(clone, named);
    let (_, owners) = key.owners(own, index);
    let mut all = suggested(inside, index).into_iter();
    key != Key::Id && !owners.is_empty() && all.any(|it| !owners.contains(&it))
}

/// The part of a name that says whose it is, and how. If a name doesn't have the pattern, the
/// instructor may have named a folder after an id.
fn part<'n>(name: &'n str, named: &NamePattern) -> (&'n str, Key) {
    let own = named.own(name).map(|own| (own, named.key()));
    own.unwrap_or((name, Key::Id))
}

/// Whether a name may be somebody's. What people have chosen counts only if `or_chosen`.
pub fn is_somebody(name: &str, index: &Index, or_chosen: bool) -> bool {
    let mut all = index.find(name).into_iter();
    let is = |it: Match| match it.kind {
        Kind::Assigned | Kind::Name => true,
        Kind::Chosen => or_chosen,
        Kind::LoneName | Kind::LoneGroup => it.is_all_of(name),
    };
    all.any(is) || !Key::Id.owners(name, index).1.is_empty()
}

#[cfg(test)]
pub mod tests;
