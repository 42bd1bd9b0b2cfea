//! Files that gradebooks import, with everyone's final mark once. People without a mark have no
//! line.

use std::collections::{BTreeMap, BTreeSet};

use super::csv::Table;
use crate::grade::class::concern::{Concern, in_words};
use crate::grade::class::{Class, Roll, Row};
use crate::grade::intake::matching::is_own_number;
use crate::grade::intake::names::{Platform, PlatformName};
use crate::grade::intake::roster::Person;
use crate::grade::policy::mark::{Mark, number};
use pinhole_report::escape::printable;

/// For Canvas: Grades, Import. `lib/gradebook_importer.rb` in Canvas's source (canvas-lms) wants
/// `Student` and `ID` first, `Section` before the assignments, and at most the two SIS columns
/// between. It finds a student by `ID`, then by `SIS User ID`, by `SIS Login ID`, or by name, which
/// may be another person's. A line with `Points Possible` sets what the assignment is worth.
/// `Name (number)` refers to an existing assignment.
pub fn canvas(class: &Class) -> String {
    let policy = class.roll.policy.as_ref();
    let column = policy.and_then(|policy| policy.rules.gradebook_column.clone());
    let column = column.unwrap_or_else(|| class.title.clone());
    let head = ["Student", "ID", "SIS User ID", "SIS Login ID", "Section"];
    let mut table = Table::new(&[&head[..], &[&column]].concat());
    let possible = class.gradebook().map(|(_, mark, _)| mark.possible);
    let possible = number(possible.fold(0.0, f64::max));
    let points = ["    Points Possible", "", "", "", "", &possible];
    table.line(&points.map(str::to_owned));
    let accounts = Accounts::new(class.roll, Platform::Canvas);
    for (person, mark, row) in class.gradebook() {
        let Some((number_there, id)) = accounts.find(person, row) else {
            continue;
        };
        // Otherwise, people may have chosen the login.
        let mut logins = person.assigned_logins().filter(|_| person.has_assigned_id);
        table.line(&[
            canvas_name(person),
            number_there,
            id,
            logins.next().cloned().unwrap_or_default(),
            person.section.clone(),
            number(mark.last),
        ]);
    }
    table.for_machines()
}

/// A person's name, for Canvas. Canvas takes every line whose name contains `Points Possible` for
/// the one that says what the assignment is worth, and people may choose their name.
fn canvas_name(person: &Person) -> String {
    printable(&person.name).replace("Points Possible", "Points possible")
}

/// For Moodle: the assignment's “Upload grading worksheet”, or the gradebook's import from CSV,
/// where `ID number` identifies the person. The first
/// (`mod/assign/feedback/offline/importgradeslib.php` in Moodle's source) needs `Identifier`,
/// `Grade` and `Last modified (grade)`, in the language of the person who uploads. It skips grades
/// above the assignment's maximum and, unless told otherwise, grades that were changed after that
/// time.
///
/// Moodle's reader (`lib/csvlib.class.php`) takes `\"` for a quotation mark inside a cell, so a cell
/// that ends in a backslash would swallow others. No cell has text that people choose themselves,
/// such as a name.
pub fn moodle(class: &Class) -> String {
    let mut table = Table::new(&[
        "Identifier",
        "ID number",
        "Grade",
        "Last modified (grade)",
        "Feedback comments",
    ]);
    let accounts = Accounts::new(class.roll, Platform::Moodle);
    for (person, mark, row) in class.gradebook() {
        let Some((number_there, id)) = accounts.find(person, row) else {
            continue;
        };
        let identifier = match number_there.is_empty() {
            true => String::new(),
            false => format!("Participant {number_there}"),
        };
        table.line(&[
            identifier,
            id,
            number(mark.last),
            String::new(),
            comments(mark).replace('\\', "/"),
        ]);
    }
    table.for_machines()
}

/// People with a mark who have no line in `canvas.csv`.
pub fn not_on_canvas(class: &Class) -> Option<Concern> {
    let what = "not in canvas.csv, because neither their number on Canvas nor their university id is \
                known: add it to the roster (column `number` or `id`)";
    not_found(class, Platform::Canvas, what)
}

/// People with a mark who have no line in `moodle.csv`.
pub fn not_on_moodle(class: &Class) -> Option<Concern> {
    let what = "not in moodle.csv, because neither their number on Moodle nor their id number is \
                known: add it to the roster (column `number` or `id`)";
    not_found(class, Platform::Moodle, what)
}

fn not_found(class: &Class, of: Platform, what: &'static str) -> Option<Concern> {
    let accounts = Accounts::new(class.roll, of);
    let lost = class.gradebook();
    let lost = lost.filter(|(person, _, row)| accounts.find(person, row).is_none());
    let which: Vec<String> = lost.map(|(person, ..)| in_words(person)).collect();
    (!which.is_empty()).then_some(Concern {
        what,
        which,
        is_grave: true,
    })
}

/// The changes. No cell begins with `+`, which a spreadsheet would take for a formula.
fn comments(mark: &Mark) -> String {
    let changes = mark.changes.iter().map(|change| change.in_words());
    match changes.collect::<Vec<_>>().join("; ") {
        changes if changes.is_empty() => changes,
        changes => format!("Changes to your mark: {changes}"),
    }
}

/// Whether the number in a platform's name is this person's.
pub fn has_number_of(name: &PlatformName, person: &Person) -> bool {
    let may_be_group = name.platform == Platform::Moodle;
    is_own_number(name.number, name.person, may_be_group, person)
}

/// The platform's numbers for people.
struct Accounts<'a> {
    of: Platform,
    /// The numbers that occur in the names of several submissions. The platform wrote only one of
    /// these names.
    contested: BTreeSet<String>,
    /// Submissions whose person is known only by a name.
    by_name: &'a [String],
}

impl Accounts<'_> {
    fn new(roll: &Roll, of: Platform) -> Accounts<'_> {
        let mut submissions: BTreeMap<&str, BTreeSet<String>> = BTreeMap::new();
        for name in roll.entries.iter().flat_map(|entry| entry.named_by(of)) {
            let all = submissions.entry(name.number).or_default();
            all.insert(name.submission);
        }
        let contested = submissions.into_iter().filter(|(_, all)| all.len() > 1);
        let contested = contested.map(|(number, _)| number.to_owned()).collect();
        Accounts {
            of,
            contested,
            by_name: &roll.placed.by_name,
        }
    }

    /// The number of a person: from the roster, or from what was handed in.
    fn number(&self, person: &Person, row: &Row) -> String {
        // The number in what was handed in is that of the person who uploaded it, not of the
        // others in the group, and perhaps of somebody who has only taken this person's name.
        let is_weak = person.has_assigned_id && self.by_name.contains(&row.entry.id);
        let is_own = !row.is_shared && !is_weak;
        let mut names = row.entry.named_by(self.of).filter(|_| is_own);
        let named = names.next().filter(|name| has_number_of(name, person));
        let named = named.map(|name| name.number.to_owned());
        let named = named.filter(|number| !self.contested.contains(number));
        person.number.clone().or(named).unwrap_or_default()
    }

    /// A person's number on the platform, and the university's id for them; `None` if neither is
    /// known.
    fn find(&self, person: &Person, row: &Row) -> Option<(String, String)> {
        let id = match person.has_assigned_id {
            true => person.id.clone(),
            false => String::new(),
        };
        let found = (self.number(person, row), id);
        (found != Default::default()).then_some(found)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grade::class::marks::rows;
    use crate::grade::class::marks::tests::{entry, roll};
    use crate::grade::intake::matching::Proof;
    use crate::grade::record::RecordSummary;
    use crate::grade::record::tests::graded;
    use crate::grade::shared_answers::KnownAnswers;

    #[test]
    fn a_number_in_the_names_of_two_people_belongs_to_neither() {
        let entries = vec![
            entry("one", "ada", "ada_77_501_hw.zip"),
            entry("two", "bob", "bob_77_999_hw.zip"),
            entry("three", "eve", "eve_79_503_hw.zip"),
        ];
        let roll = roll(entries, "time_zone = 'UTC'", &[]);
        let accounts = Accounts::new(&roll, Platform::Canvas);
        let records = BTreeMap::new();
        let numbers = rows(&roll, &records).own.into_iter().map(|row| {
            let person = row.person.expect("it is somebody's");
            accounts.number(person, &row)
        });
        assert_eq!(numbers.collect::<Vec<_>>(), ["", "", "79"]);
    }

    #[test]
    fn a_number_beside_a_name_that_anybody_may_have_taken_gives_nobody_anothers_changes() {
        let mut roll = roll(
            vec![entry("one", "ada", "ada_79_503_hw.zip")],
            "time_zone = 'UTC'",
            &[],
        );
        roll.entries[0].at_most = Proof::Name;
        for (has_assigned_id, number) in [(true, ""), (false, "79")] {
            let people = roll.people.as_mut().expect("it has people");
            people[0].has_assigned_id = has_assigned_id;
            roll.place();
            let accounts = Accounts::new(&roll, Platform::Canvas);
            let records = BTreeMap::new();
            let rows = rows(&roll, &records);
            let ada = rows.own[0].person.expect("it is Ada's");
            assert_eq!(accounts.number(ada, &rows.own[0]), number);
        }
    }

    #[test]
    fn the_number_of_a_group_on_moodle_is_not_taken_for_a_members() {
        let entries = vec![
            entry("one", "ada", "Team A_3001_assignsubmission_file"),
            entry("two", "eve", "Name of eve_2002_assignsubmission_file"),
        ];
        for (group, numbers) in [("Team B", ["", "2002", ""]), ("Name of eve", ["", "", ""])] {
            let groups: [(&str, &[&str]); 2] = [("Team A", &["ada", "bob"]), (group, &["eve"])];
            let roll = roll(entries.clone(), "time_zone = 'UTC'", &groups);
            let accounts = Accounts::new(&roll, Platform::Moodle);
            let records = BTreeMap::new();
            let rows = rows(&roll, &records);
            let all = rows.own.iter().chain(&rows.shared);
            let found = all.map(|row| accounts.number(row.person.expect("a person"), row));
            assert_eq!(found.collect::<Vec<_>>(), numbers, "{group}");
        }
    }

    /// What is made of a class in which these people have 60 points each.
    fn of_class<T>(roll: &mut Roll, people: Vec<Person>, of: impl FnOnce(&Class) -> T) -> T {
        let entries = people.iter().map(|it| entry(&it.id, &it.id, &it.id));
        roll.entries = entries.collect();
        roll.people = Some(people);
        roll.place();
        let ids = roll.entries.iter().map(|it| it.id.clone());
        let records: BTreeMap<String, RecordSummary> = ids
            .map(|id| (id.clone(), graded(&id, 60, 100).into()))
            .collect();
        of(&Class::new("HW", roll, &records, &KnownAnswers::default()))
    }

    #[test]
    fn nobodys_name_moves_a_mark_on_moodle() {
        let person = |id: &str, number: Option<&str>| Person {
            id: id.into(),
            name: "Eve,\\".into(),
            has_assigned_id: id == "bob",
            number: number.map(str::to_owned),
            logins: vec!["\\@example.org".into()],
            ..Person::default()
        };
        let people = vec![
            person("a@example.org", Some("2001")),
            person("bob", None),
            person("c@example.org", None),
        ];
        let rules = "[[adjust]]\nid = 'bob'\npoints = 1\nreason = 'see \"C:\\\"'\n";
        let mut roll = roll(Vec::new(), rules, &[]);
        let (table, lost) = of_class(&mut roll, people, |class| {
            (moodle(class), not_on_moodle(class))
        });
        let lines = "Identifier,ID number,Grade,Last modified (grade),Feedback comments\n\
            Participant 2001,,60,,\n\
            ,bob,61,,\"Changes to your mark: +1: see \"\"C:/\"\"\"\n";
        assert_eq!(table, lines);
        let lost = lost.expect("one has no number");
        assert!(lost.is_grave && lost.which == ["Eve,\\ [c@example.org]"]);
    }

    #[test]
    fn only_an_id_that_the_university_assigned_identifies_people_on_canvas() {
        let person = |id: &str, number: Option<&str>| Person {
            id: id.into(),
            has_assigned_id: id == "ada",
            number: number.map(str::to_owned),
            logins: vec![format!("{id}1")],
            ..Person::default()
        };
        // Bob and Eve have logins on GitHub that are other people's ids.
        let people = vec![
            person("ada", None),
            person("bob", Some("12")),
            person("eve", None),
        ];
        let mut roll = roll(Vec::new(), "time_zone = 'UTC'", &[]);
        let (table, lost) = of_class(&mut roll, people, |class| {
            (canvas(class), not_on_canvas(class))
        });
        let lines = "Student,ID,SIS User ID,SIS Login ID,Section,HW\n    Points Possible,,,,,100\n\
            ,,ada,ada1,,60\n,12,,,,60\n";
        assert_eq!(table, lines);
        let lost = lost.expect("one has no number");
        assert!(lost.is_grave && lost.which == [" [eve]"]);
    }

    #[test]
    fn no_students_name_is_taken_for_the_line_points_possible() {
        for name in ["Points Possible", "Eve Points Possible", "Points\tPossible"] {
            let person = Person {
                name: name.into(),
                ..Person::default()
            };
            let mut table = Table::new(&["Student"]);
            table.line(&[canvas_name(&person)]);
            let text = table.for_machines();
            assert!(!text.contains("Points Possible"), "{text}");
        }
    }
}
