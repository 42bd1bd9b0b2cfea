//! Whose repository on GitHub a folder is: its name is the title of the assignment, a hyphen, and the
//! login of a person or the name of a team. The name of a branch may follow.
//!
//! No two accounts have the same login, and logins that differ by a hyphen are different. So a repository
//! belongs to the person with exactly this login, whatever others call themselves. But people may have logins such as `hw1-ada`, or
//! many accounts such as `zz-ada`, so that another title seems to stand before Ada's login. So the title
//! counts that explains most names, unless a shorter one explains names that begin otherwise.

use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet, HashMap};

use super::index::{Index, words};
use super::matching::{Proof, folded, has_chosen_id, turned, without_accents};
use super::roster::Person;

/// How the repositories of a class are named.
pub struct Repositories<'a> {
    people: &'a [Person],
    owners: Owners<'a>,
    /// What names may consist of: first the form that explains most names. For each, these are other
    /// forms that explain more than half of the same names.
    forms: Vec<(Form, Vec<Form>)>,
}

/// What a name may consist of. Folders that the instructor has named hold ids or names of people.
#[derive(Clone, Debug, Eq, Ord, PartialEq, PartialOrd)]
struct Form {
    title: String,
    of: Owner,
    ending: String,
}

#[derive(Clone, Copy, Debug, Eq, Hash, Ord, PartialEq, PartialOrd)]
enum Owner {
    Login,
    Team,
    Id,
    Name,
}

const OWNERS: [Owner; 4] = [Owner::Login, Owner::Team, Owner::Id, Owner::Name];

impl Form {
    /// The part of a name that says whose it is.
    fn own<'t>(&self, name: &'t str) -> Option<&'t str> {
        let rest = name.strip_prefix(&*self.title)?;
        rest.strip_suffix(&*self.ending)
    }

    fn is_of_github(&self) -> bool {
        matches!(self.of, Owner::Login | Owner::Team)
    }
}

impl<'a> Repositories<'a> {
    /// Looks at the names of a class, and what most of them end with.
    pub fn of(names: &[&str], ending: &str, index: &Index<'a>) -> Option<Repositories<'a>> {
        let owners = Owners::of(index.people);
        let mut explained: BTreeMap<Form, BTreeSet<&str>> = BTreeMap::new();
        for name in names {
            for form in forms(name, ending) {
                if form
                    .own(name)
                    .is_some_and(|own| owners.only(form.of, own).is_some())
                {
                    explained.entry(form).or_default().insert(name);
                }
            }
        }
        let is_form = |form: &Form| {
            let all = names.iter().filter(|name| name.starts_with(&form.title));
            let others = all.filter(|name| !name.ends_with(&form.ending)).count();
            // All names in the export begin with the assignment's title.
            let mut shorter = explained.iter().filter(|(it, _)| {
                it.is_of_github() && !it.title.is_empty() && form.title.starts_with(&it.title)
            });
            others < 2
                && !shorter.any(|(_, names)| names.iter().any(|it| !it.starts_with(&form.title)))
        };
        let all = explained.iter().filter(|(form, _)| is_form(form));
        let mut all: Vec<_> = all.collect();
        all.sort_by_key(|(form, names)| (Reverse((names.len(), form.title.len())), form.of));
        let likely = |(form, names): (&Form, &BTreeSet<&str>)| {
            let others = all.iter().filter(|(it, theirs)| {
                *it != form && 2 * names.intersection(theirs).count() > names.len()
            });
            let others: Vec<Form> = others.map(|(it, _)| (*it).clone()).collect();
            (form.clone(), others)
        };
        let several = all.iter().copied();
        let several = several.filter(|(form, names)| form.is_of_github() && names.len() > 1);
        let forms = several.map(likely).collect();
        let found = Repositories {
            people: index.people,
            owners,
            forms,
        };
        let certain = names.iter().filter(|name| found.only(name).is_some());
        (certain.count() > 1).then_some(found)
    }

    /// The form of a name, and others that it may have. A folder may hold several exports.
    fn form(&self, name: &str) -> Option<&(Form, Vec<Form>)> {
        let mut forms = self.forms.iter();
        forms.find(|(form, _)| name.starts_with(&form.title))
    }

    /// The title, if this is the name of a repository, perhaps of somebody whose login is not known.
    pub fn title(&self, name: &str) -> Option<&str> {
        let title = self.form(name).map(|(form, _)| &*form.title);
        title.filter(|title| !title.is_empty())
    }

    /// Whether somebody may own something with this name. A repository of theirs is named after their
    /// login, perhaps with something behind it.
    pub fn may_own(&self, person: &Person, name: &str) -> bool {
        let (Some((form, _)), Some(login)) = (self.form(name), &person.github) else {
            return true;
        };
        let own = name[form.title.len()..].to_lowercase();
        let rest = own.strip_prefix(&login.to_lowercase());
        let is_login = rest.is_some_and(|it| it.is_empty() || it.starts_with('-'));
        form.title.is_empty() || form.of == Owner::Team || is_login
    }

    /// The owner of a repository with this name, unless it may have another form, and mean somebody else.
    fn only(&self, name: &str) -> Option<&'a Person> {
        let (form, others) = self.form(name)?;
        let owner = self.owners.only(form.of, form.own(name)?)?;
        let others = others.iter();
        let mut others = others.filter_map(|it| self.owners.only(it.of, it.own(name)?));
        others.all(|it| it == owner).then_some(owner)
    }

    /// The owner, and how much the name proves. A login such as `ada-draft` may also be somebody else's,
    /// and a branch or a number that GitHub adds.
    pub fn owner(&self, name: &str) -> Option<(Proof, &'a Person)> {
        let owner = self.only(name)?;
        let (form, _) = self.form(name)?;
        let own = form.own(name)?.to_lowercase();
        let is_added = |end: &str| {
            ["main", "master", "feedback"].contains(&end)
                || end.bytes().all(|it| it.is_ascii_digit())
        };
        let may_be_branch = own.rsplit_once('-').is_some_and(|(_, end)| is_added(end))
            || own.match_indices('-').any(|(at, _)| {
                let is_known = self.people.iter().all(|it| it.github.is_some());
                !is_known || self.owners.only(Owner::Login, &own[..at]).is_some()
            });
        let proof = match form.of == Owner::Login && !may_be_branch {
            true => Proof::Id,
            false => Proof::Given,
        };
        Some((proof, owner))
    }
}

/// All forms that a name may have.
fn forms<'n>(name: &'n str, ending: &'n str) -> impl Iterator<Item = Form> + 'n {
    let starts = words(name).into_iter().map(|it| it.start);
    let starts = starts.filter(|at| *at == 0 || name[..*at].ends_with('-'));
    let endings = ["", ending]
        .into_iter()
        .take(1 + usize::from(!ending.is_empty()));
    starts.flat_map(move |start| {
        endings.clone().flat_map(move |ending| {
            OWNERS.map(|of| Form {
                title: name[..start].to_owned(),
                of,
                ending: ending.to_owned(),
            })
        })
    })
}

/// People by what they are called in the names of folders.
struct Owners<'a>(HashMap<(Owner, String), Vec<&'a Person>>);

impl<'a> Owners<'a> {
    fn of(people: &'a [Person]) -> Owners<'a> {
        let mut owners = Owners(HashMap::new());
        for person in people {
            let own = person.github.iter().map(|it| it.to_lowercase());
            owners.add(Owner::Login, person, own);
            let own = person.group.iter().map(|it| in_address(it));
            owners.add(Owner::Team, person, own);
            let id = (!has_chosen_id(person)).then_some(&person.id);
            let own = id.into_iter().chain(person.assigned_logins());
            owners.add(Owner::Id, person, own.map(|it| it.to_lowercase()));
            owners.add(
                Owner::Name,
                person,
                turned(&person.name, folded).into_iter(),
            );
        }
        // GitHub may drop the accents of a team's name, and not the letters.
        for person in people {
            let own = person
                .group
                .iter()
                .map(|it| in_address(&without_accents(it)));
            let free: Vec<_> = own
                .filter(|it| !owners.0.contains_key(&(Owner::Team, it.clone())))
                .collect();
            owners.add(Owner::Team, person, free.into_iter());
        }
        owners
    }

    fn add(&mut self, of: Owner, person: &'a Person, own: impl Iterator<Item = String>) {
        for own in own {
            let all = self.0.entry((of, own)).or_default();
            if !all.contains(&person) {
                all.push(person);
            }
        }
    }

    /// The only person who is called so.
    fn only(&self, of: Owner, own: &str) -> Option<&'a Person> {
        let own = match of {
            Owner::Name => folded(own),
            Owner::Team => own.to_lowercase().replace('_', "-"),
            _ => own.to_lowercase(),
        };
        match self.0.get(&(of, own))?[..] {
            [only] => Some(only),
            _ => None,
        }
    }
}

/// How GitHub writes a team's name in addresses: without letters that aren't ASCII.
fn in_address(team: &str) -> String {
    let team = team.to_lowercase();
    let words = team.split(|c: char| !c.is_ascii_alphanumeric());
    let words: Vec<&str> = words.filter(|it| !it.is_empty()).collect();
    words.join("-")
}

#[cfg(test)]
mod tests;
