//! What the instructor should look at before marks go out: missing people, files that were not
//! taken, ambiguous names. The terminal, the page and JSON all show the same.

use serde::Serialize;

use super::{Roll, Row};
use crate::grade::intake::Entry;
use crate::grade::intake::roster::Person;
use pinhole_course::outcome::Status;

/// One kind of problem, and where it occurs.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Concern {
    pub what: &'static str,
    pub which: Vec<String>,
    /// Whether someone may have lost points because of it. If so, the exit code is 1.
    pub is_grave: bool,
}

impl Roll {
    /// All concerns of a class, the most serious first.
    pub fn concerns(&self) -> Vec<Concern> {
        let placed = &self.placed;
        let entries = |of: &dyn Fn(&Entry) -> &Vec<String>| {
            let with = self.entries.iter().filter(|entry| !of(entry).is_empty());
            with.map(|entry| format!("{}: {}", self.called(&entry.id), of(entry).join("; ")))
                .collect::<Vec<_>>()
        };
        let people = |people: &[Person]| people.iter().map(in_words).collect();
        let ambiguous = placed.ambiguous.iter().map(|(id, people)| {
            let people: Vec<String> = people.iter().map(in_words).collect();
            format!("{}: perhaps {}", self.called(id), people.join(" or "))
        });
        let superseded = placed.superseded.iter();
        let superseded = superseded.map(|(upload, id)| format!("{upload} (graded: {id})"));
        let all: [(&str, bool, Vec<String>); 11] = [
            (
                "with missing or refused answer files",
                true,
                entries(&|it| &it.unusable),
            ),
            (
                "whose files you should check",
                true,
                entries(&|it| &it.doubts),
            ),
            (
                "whose owner is uncertain: put each into a folder named after the person's id, or say \
                 how all of them are named (such as `--named 'hw1-{github}'`, or `--named 'HW1_{id}'` for \
                 Blackboard)",
                true,
                ambiguous.collect(),
            ),
            ("not on the roster", true, self.names(&placed.unknown)),
            (
                "matched by a name, an address or a login that may be somebody else's: check them, or add the \
                 platform's numbers (column `number`), logins (column `login`) or GitHub logins (column \
                 `github`) to the roster. For Blackboard, say what stands before the logins (such as \
                 `--named 'HW1_{id}'`)",
                false,
                self.names(&placed.by_name),
            ),
            (
                "matched by an id, a login or a group's name, but somebody else may be meant: check them",
                false,
                self.names(&placed.contested),
            ),
            ("not part of any submission", true, self.ignored.clone()),
            (
                "new, or with other answers than before, but with the same time in the table, which may say \
                 when earlier answers were handed in: grade the whole class with a newer table (`times` in \
                 policy.toml), or check that it is right",
                true,
                self.with_old_times()
                    .iter()
                    .map(|it| self.called(&it.id))
                    .collect(),
            ),
            ("who handed in nothing", false, people(&placed.missing)),
            (
                "read despite an unexpected name, encoding or number of uploads",
                false,
                entries(&|it| &it.notes),
            ),
            (
                "not graded, because there is a later upload",
                false,
                superseded.collect(),
            ),
        ];
        let all = all.into_iter().filter(|(_, _, which)| !which.is_empty());
        all.map(|(what, is_grave, which)| Concern {
            what,
            which,
            is_grave,
        })
        .collect()
    }

    /// A sentence that says how many people on the roster are graded (or, before grading, ready to
    /// be graded), and how many are affected by each problem.
    pub fn headline(&self, graded: &dyn Fn(&str) -> bool, word: &str) -> String {
        let placed = &self.placed;
        let count = |count: usize, one: &str, many: &str| match count {
            1 => format!("1 {one}"),
            _ => format!("{count} {many}"),
        };
        let are = |graded: usize| count(graded, &format!("is {word}"), &format!("are {word}"));
        let mut parts = Vec::new();
        match placed.people {
            Some(people) => {
                let own = are(self.people_graded(graded));
                let people = count(people, "person", "people");
                parts.push(format!("of {people} on the roster, {own}"));
                let in_doubt = self.in_doubt().len();
                if in_doubt > 0 {
                    parts.push(format!("{in_doubt} in doubt"));
                }
                parts.push(format!("{} handed in nothing", placed.missing.len()));
            }
            None => {
                let all = count(self.entries.len(), "submission", "submissions");
                let own = self.entries.iter().filter(|entry| graded(&entry.id));
                parts.push(format!("of {all}, {}", are(own.count())));
            }
        }
        let incomplete = self
            .entries
            .iter()
            .filter(|entry| !entry.unusable.is_empty());
        parts.push(count(
            incomplete.count(),
            "submission lacks answer files",
            "submissions lack answer files",
        ));
        let ignored = self.ignored.len();
        let to_none = "to no submission";
        parts.push(count(
            ignored,
            &format!("file belongs {to_none}"),
            &format!("files belong {to_none}"),
        ));
        parts.join("; ")
    }

    fn people_graded(&self, graded: &dyn Fn(&str) -> bool) -> usize {
        let of = self.placed.of.iter().filter(|(id, _)| graded(id));
        let people = of.flat_map(|(_, person)| self.team_of(person));
        let mut people: Vec<&str> = people.map(|person| person.id.as_str()).collect();
        people.sort();
        people.dedup();
        people.len()
    }

    /// Whose a submission is, or may be; `None` without a roster.
    pub fn whose(&self, id: &str) -> Option<String> {
        self.placed.people?;
        let perhaps = self.placed.ambiguous.get(id);
        Some(match (self.placed.of.get(id), perhaps) {
            (Some(person), _) => format!("by {}", in_words(person)),
            (None, Some(people)) => {
                let people: Vec<String> = people.iter().map(in_words).collect();
                format!("belongs to nobody, perhaps to {}", people.join(" or "))
            }
            (None, None) => "by nobody on the roster".into(),
        })
    }

    /// The name of a submission, and the person's name if that adds something.
    fn called(&self, id: &str) -> String {
        match self.placed.of.get(id) {
            Some(person) if person.id != id => format!("{id} ({})", in_words(person)),
            _ => id.to_owned(),
        }
    }

    fn names(&self, ids: &[String]) -> Vec<String> {
        ids.iter().map(|id| self.called(id)).collect()
    }
}

/// Answers that cost points before any number was compared: they don't compile, crash, never end or
/// were not written.
pub fn without_numbers(rows: &[Row]) -> Option<Concern> {
    let compared = [Status::MissingFile, Status::RefusedFile, Status::Graded];
    let which = rows.iter().filter_map(|row| {
        let tasks = row.record?.tasks.iter().map(|task| &task.task);
        let tasks = tasks.filter(|task| task.points < task.possible);
        let tasks = tasks.filter(|task| !compared.contains(&task.status));
        let tasks: Vec<String> = tasks
            .map(|task| format!("{} {}", task.name, task.status.word()))
            .collect();
        (!tasks.is_empty()).then(|| format!("{}: {}", row.entry.id, tasks.join(", ")))
    });
    let which: Vec<String> = which.collect();
    (!which.is_empty()).then_some(Concern {
        what: "with answers that could not be compared",
        which,
        is_grave: false,
    })
}

/// Sorts concerns, the most serious first.
pub fn sorted(mut all: Vec<Concern>) -> Vec<Concern> {
    all.sort_by_key(|concern| !concern.is_grave);
    all
}

/// A person's name and id.
pub fn in_words(person: &Person) -> String {
    format!("{} [{}]", person.name, person.id)
}
