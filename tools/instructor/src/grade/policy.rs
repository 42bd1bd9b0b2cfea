//! The lecturer's policy: how judged points become the final mark in a gradebook.
//!
//! Reading order: [`rules`] is `policy.toml` as a lecturer writes it; [`times`] says when
//! something was handed in, and how late that is; [`mark`] applies the rules to one mark.

pub mod mark;
pub mod rules;
pub mod times;

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use jiff::{Timestamp, tz::TimeZone};
use serde::{Deserialize, Serialize};

use self::rules::Rules;
use self::times::TimeLine;
use super::intake::index::{Index, Kind};
use super::intake::roster::Person;
use super::intake::table::Table;
use pinhole_course::assignment::Assignment;
use pinhole_course::error::{Error, Result, ResultExt};
use pinhole_report::escape::printable_cell;

/// The rules, and the contents of the files that they name.
#[derive(Clone, Debug, Default, Deserialize, PartialEq, Serialize)]
pub struct Policy {
    pub rules: Rules,
    /// The deadline, and the deadlines of people who have their own, by id.
    deadline: Option<Timestamp>,
    extensions: BTreeMap<String, Timestamp>,
    /// The table that says when something was handed in.
    pub times: Vec<TimeLine>,
    /// Late days that were spent on earlier assignments, by id as `grades.csv` writes it: see
    /// [`printable_cell`](pinhole_report::escape::printable_cell).
    spent: BTreeMap<String, u32>,
    pub groups: Vec<Group>,
}

/// What identifies a person or a submission in a table of times.
#[derive(Clone, Copy, Debug, Deserialize, Eq, PartialEq, Serialize)]
pub enum TimeKey {
    /// A person's id.
    Id,
    /// A submission's name.
    Submission,
    /// The platform's number for a person.
    Number,
    /// A login or an e-mail address.
    Login,
}

/// People who hand in one answer together.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub struct Group {
    pub name: String,
    /// Their ids.
    pub members: Vec<String>,
}

/// Names of the column that identifies the person in a table.
const WHO: [(&str, TimeKey); 12] = [
    ("id", TimeKey::Id),
    ("idnumber", TimeKey::Id),
    ("sisuserid", TimeKey::Id),
    ("sid", TimeKey::Id),
    ("studentid", TimeKey::Id),
    ("identifier", TimeKey::Number),
    ("submission", TimeKey::Submission),
    ("emailaddress", TimeKey::Login),
    ("email", TimeKey::Login),
    ("login", TimeKey::Login),
    ("sisloginid", TimeKey::Login),
    ("username", TimeKey::Login),
];

impl Policy {
    /// Reads `policy.toml` and the tables it names, relative to its folder.
    pub fn read(path: &Path, assignment: &Assignment) -> Result<Policy> {
        let remedy =
            "see the chapter “Policies and gradebooks” and tools/schema/policy.schema.json";
        let text = fs::read_to_string(path).or_input(
            format_args!("cannot read {}", path.display()),
            "name a policy.toml",
        )?;
        let name = path.display().to_string();
        let rules: Rules = toml::from_str(&text).or_input(&name, remedy)?;
        let wrong = |why: String| Error::input(&name, remedy).because(why);
        let mut policy = Policy::of(rules).map_err(wrong)?;
        let tasks = assignment.tasks.iter().map(|task| task.name.as_str());
        let parts: Vec<&str> = tasks.chain(["scenes"]).collect();
        for part in policy.rules.extra_credit.iter().flat_map(|it| &it.parts) {
            if !parts.contains(&part.as_str()) {
                let all = parts.join(", ");
                let why = format!("extra_credit.parts has `{part}`, but the parts are {all}");
                return Err(wrong(why));
            }
        }
        let zone = times::zone(policy.rules.time_zone.as_deref()).map_err(wrong)?;
        let beside = path.parent().unwrap_or(Path::new(""));
        if let Some(file) = &policy.rules.times {
            policy.times = times_in(&beside.join(file), zone.as_ref())?;
        }
        if let Some(file) = &policy.rules.groups {
            policy.groups = groups_in(&beside.join(file))?;
        }
        for file in policy.rules.late_days.iter().flat_map(|it| &it.spent) {
            for (id, days) in late_days_in(&beside.join(file))? {
                let spent = policy.spent.entry(id).or_default();
                *spent = spent.saturating_add(days);
            }
        }
        Ok(policy)
    }

    /// The policy of these rules, without the tables that they name. An error says what is wrong
    /// with the rules.
    pub fn of(rules: Rules) -> std::result::Result<Policy, String> {
        rules.check()?;
        let zone = times::zone(rules.time_zone.as_deref())?;
        let time = |text: &String| times::timestamp(text, zone.as_ref());
        let extensions = rules.extensions.iter();
        let extensions = extensions.map(|(id, until)| Ok((id.clone(), time(until)?)));
        Ok(Policy {
            deadline: rules.deadline.as_ref().map(time).transpose()?,
            extensions: extensions.collect::<std::result::Result<_, String>>()?,
            rules,
            ..Policy::default()
        })
    }

    /// The groups whose name is the id or login of somebody else, or like one. A submission with such
    /// a name may count as that person's.
    pub fn misnamed_groups(&self, people: &[Person]) -> Vec<String> {
        let index = Index::of(people);
        let is_misnamed = |group: &&Group| {
            let mut all = index.whole(&group.name);
            all.any(|(it, kind)| kind == Kind::Assigned && !group.members.contains(&it.id))
        };
        let misnamed = self.groups.iter().filter(is_misnamed);
        misnamed.map(|group| group.name.clone()).collect()
    }

    /// The time zone that the rules are in.
    pub fn zone(&self) -> TimeZone {
        let zone = times::zone(self.rules.time_zone.as_deref());
        zone.ok().flatten().unwrap_or(TimeZone::UTC)
    }

    /// The group of people who get the mark for what this person hands in.
    pub fn group_of(&self, id: &str) -> Option<&Group> {
        let mut groups = self.groups.iter();
        groups.find(|group| group.members.iter().any(|member| member == id))
    }

    /// Ids in the policy that nobody on the roster has. Such an id is probably misspelt, and
    /// someone is waiting for an extension or an adjustment.
    pub fn strangers(&self, people: &[Person]) -> Vec<String> {
        let by_hand = self.rules.adjust.iter().map(|by_hand| &by_hand.id);
        let grouped = self.groups.iter().flat_map(|group| &group.members);
        let all = self.extensions.keys().chain(by_hand).chain(grouped);
        let all = all.chain(self.spent.keys());
        let is = |own: &str, id: &str| own == id || printable_cell(own) == id;
        let is_stranger = |id: &&String| !people.iter().any(|person| is(&person.id, id));
        let mut all: Vec<String> = all.filter(is_stranger).cloned().collect();
        all.sort();
        all.dedup();
        all
    }
}

fn cell(row: &csv::StringRecord, column: usize) -> &str {
    row.get(column).unwrap_or_default().trim()
}

fn times_in(path: &Path, zone: Option<&TimeZone>) -> Result<Vec<TimeLine>> {
    const TIME: [&str; 6] = [
        "time",
        "submissiontime",
        "submitted",
        "submittedat",
        "lastmodifiedsubmission",
        "created",
    ];
    let remedy = "save it as a CSV file whose first line is: id,time";
    Table::read(path, "list of times", remedy, |table| {
        let who = WHO.iter();
        let who = who.filter_map(|(name, kind)| Some((*kind, table.column(&[name])?)));
        let who: Vec<(TimeKey, usize)> = who.collect();
        if who.is_empty() {
            table.needed_column(&WHO.map(|(name, _)| name))?;
        }
        let time = table.needed_column(&TIME)?;
        let of = |(line, row): &(u64, csv::StringRecord)| {
            let at = match cell(row, time) {
                "" | "-" => None,
                text => {
                    let at = times::timestamp(text, zone);
                    Some(at.map_err(|why| format!("line {line}: {why}"))?)
                }
            };
            let keys = who.iter().map(|(kind, column)| {
                let who = cell(row, *column);
                (*kind, who.strip_prefix("Participant ").unwrap_or(who))
            });
            let keys = keys.filter(|(_, key)| !key.is_empty());
            let keys = keys.map(|(kind, key)| (kind, key.to_owned())).collect();
            Ok(TimeLine { keys, at })
        };
        table.rows.iter().map(of).collect()
    })
}

/// What tells groups apart. Two of them may have the same name, or nearly so, and one may be named
/// like the number of another.
#[derive(Eq, Ord, PartialEq, PartialOrd)]
enum GroupKey<'a> {
    /// The platform's number.
    Number(&'a str),
    /// The group's name, if it has no number.
    Name(&'a str),
}

fn groups_in(path: &Path) -> Result<Vec<Group>> {
    let remedy = "save it as a CSV file whose first line is: id,group";
    // The id of a person without a university id is Canvas's number.
    const MEMBER: [&str; 5] = ["id", "userid", "sisuserid", "idnumber", "canvasuserid"];
    Table::read(path, "list of groups", remedy, |table| {
        table.needed_column(&MEMBER)?;
        let who: Vec<usize> = MEMBER.iter().filter_map(|it| table.column(&[it])).collect();
        let name = table.needed_column(&["group", "groupname", "team"])?;
        let key = table.column(&["canvasgroupid", "groupid"]).unwrap_or(name);
        let mut groups: BTreeMap<GroupKey, Group> = BTreeMap::new();
        let mut alone = BTreeSet::new();
        for (line, row) in &table.rows {
            let mut ids = who.iter().map(|column| cell(row, *column));
            let id = ids.find(|id| !id.is_empty()).unwrap_or_default();
            let called = cell(row, name);
            let mut members = groups.values().flat_map(|group| &group.members);
            if members.any(|other| other == id) {
                return Err(format!("line {line}: {id} is already in a group"));
            }
            // Some people are in no group.
            if called.is_empty() {
                alone.insert(id);
                continue;
            }
            // One person's number on Canvas may be another's id.
            if alone.contains(id) {
                return Err(format!(
                    "line {line}: {id} is already listed, without a group"
                ));
            }
            let own = match cell(row, key) {
                number if key != name && !number.is_empty() => GroupKey::Number(number),
                _ => GroupKey::Name(row.get(name).unwrap_or_default()),
            };
            let is_twin =
                |(other, group): (&GroupKey, &Group)| *other != own && group.name == called;
            if matches!(own, GroupKey::Name(_)) && groups.iter().any(is_twin) {
                return Err(format!(
                    "line {line}: the names of two groups differ only in spaces: {called}"
                ));
            }
            let new = || Group {
                name: called.into(),
                members: Vec::new(),
            };
            let group = groups.entry(own).or_insert_with(new);
            group.members.push(id.into());
        }
        Ok(groups.into_values().collect())
    })
}

fn late_days_in(path: &Path) -> Result<Vec<(String, u32)>> {
    let remedy = "name a grades.csv that `pinhole grade --policy` has written";
    Table::read(path, "grades.csv", remedy, |table| {
        let (id, days) = (
            table.needed_column(&["id"])?,
            table.needed_column(&["latedays"])?,
        );
        // Submissions that belong to nobody have lines without an id.
        let has_both = |row| !cell(row, id).is_empty() && !cell(row, days).is_empty();
        let rows = table.rows.iter().filter(|(_, row)| has_both(row));
        let of = |(line, row): &(u64, csv::StringRecord)| {
            let days = cell(row, days).parse();
            let days = days.map_err(|_| format!("line {line}: late_days is not a number"))?;
            Ok((cell(row, id).to_owned(), days))
        };
        rows.map(of).collect()
    })
}

#[cfg(test)]
mod tests {

    use super::*;
    use pinhole_course::checkout::Checkout;
    use pinhole_testing::root;

    fn assignment() -> Assignment {
        let checkout = Checkout::at(&root());
        Assignment::read(&checkout, "ray_casting").expect("it is committed")
    }

    #[test]
    fn people_without_a_university_id_are_in_groups_by_their_number_on_canvas() {
        let folder = tempfile::tempdir().expect("there is room");
        let path = folder.path().join("groups.csv");
        let list = "name,canvas_user_id,user_id,login_id,sections,group_name,canvas_group_id,group_id\n\
            Ada,11,S1,ada,A,Team A,7,\nBob,12,,bob,A,Team A,7,\nCleo,13,,cleo,A,,,\n";
        fs::write(&path, list).expect("there is room");
        let groups = groups_in(&path).expect("it is a list of groups");
        let groups: Vec<_> = groups
            .iter()
            .map(|it| (&*it.name, &it.members[..]))
            .collect();
        assert_eq!(
            groups,
            [("Team A", &["S1".to_owned(), "12".to_owned()][..])]
        );
    }

    #[test]
    fn nobody_joins_a_group_because_their_id_is_anothers_number_on_canvas() {
        let folder = tempfile::tempdir().expect("there is room");
        let path = folder.path().join("groups.csv");
        let (ada, eve) = ("11,12,\n", "12,,T\n");
        for rows in [[ada, eve], [eve, ada]] {
            let list = format!("canvas_user_id,user_id,group_name\n{}", rows.concat());
            fs::write(&path, list).expect("there is room");
            groups_in(&path).expect_err("nobody knows who is in the group");
        }
    }

    #[test]
    fn a_group_named_like_somebody_elses_id_is_listed() {
        let group = |name: &str, member: &str| Group {
            name: name.into(),
            members: vec![member.into()],
        };
        let policy = Policy {
            groups: vec![
                group("ADA", "eve"),
                group("a-da", "eve"),
                group("eve", "eve"),
                group("T", "ada"),
            ],
            ..Policy::default()
        };
        let people = ["ada", "eve"].map(|id| Person {
            id: id.into(),
            ..Person::default()
        });
        assert_eq!(policy.misnamed_groups(&people), ["ADA", "a-da"]);
    }

    #[test]
    fn a_group_named_like_another_one_does_not_get_its_mark() {
        let folder = tempfile::tempdir().expect("there is room");
        let read = |text: &str| {
            let path = folder.path().join("groups.csv");
            fs::write(&path, text).expect("there is room");
            groups_in(&path).map_err(|error| error.to_string())
        };
        let canvas = "user_id,group_name,canvas_group_id\nada,T,7\nbob,T,7\neve,T,8\nzoe,,\n";
        let members: Vec<_> = read(canvas).expect("it is a list").into_iter().collect();
        let members: Vec<_> = members
            .iter()
            .map(|group| group.members.join(" "))
            .collect();
        assert_eq!(members, ["ada bob", "eve"]);
        let unnumbered = read("user_id,group_name,group_id\nada,T,\nbob,T,\neve,U,\n");
        let unnumbered = unnumbered.expect("it is a list");
        assert_eq!(
            unnumbered.len(),
            2,
            "groups without a number go by their names"
        );
        for twin in ["T ", "\u{a0}T"] {
            let error = read(&format!("id,group\nada,T\neve,{twin}\n"));
            let error = error.expect_err("nobody knows whether they are the same");
            assert!(error.contains("differ only in spaces"), "{error}");
        }
        let plain = read("id, group\nada,T\n bob ,T\neve,t\n").expect("it is a list");
        assert_eq!(plain.len(), 2);
        assert_eq!(plain[0].members, ["ada", "bob"]);
    }

    #[test]
    fn a_group_named_like_another_ones_number_does_not_get_its_mark() {
        let folder = tempfile::tempdir().expect("there is room");
        let path = folder.path().join("groups.csv");
        let rows = ["ada,Owls,7\n", "bob,Owls,7\n", "eve,7,\n"];
        for order in [[0, 1, 2], [2, 1, 0]] {
            let rows = order.map(|at| rows[at]).concat();
            fs::write(&path, format!("user_id,group_name,group_id\n{rows}"))
                .expect("there is room");
            let groups = groups_in(&path).expect("it is a list of groups");
            let of_eve = groups.iter().find(|it| it.members.contains(&"eve".into()));
            let of_eve = of_eve.expect("she is in a group");
            assert_eq!((&*of_eve.name, of_eve.members.len()), ("7", 1));
        }
    }

    #[test]
    fn nobody_is_late_because_their_id_is_anothers_login_or_number() {
        use crate::grade::class::marks::tests::entry;
        use crate::grade::intake::Entry;
        use crate::grade::intake::names::{HandInTime, Sign};

        let folder = tempfile::tempdir().expect("there is room");
        let path = folder.path().join("times.csv");
        let list = "Identifier,ID number,login,time\n\
            Participant 2001,77,bob,2026-11-20 10:00\n\
            Participant 2002,78,77,2026-11-27 10:00\n\
            Participant 77,79,eve,2026-11-28 10:00\n\
            Participant 2004,,zoe,2026-11-19 10:00\n";
        fs::write(&path, list).expect("there is room");
        let mut policy = Policy {
            times: times_in(&path, Some(&TimeZone::UTC)).expect("it is a list of times"),
            ..Policy::default()
        };
        let handed_in = |entry: &Entry, id: &str, number: Option<&str>, login: &str| {
            let person = Person {
                id: id.into(),
                number: number.map(str::to_owned),
                logins: vec![login.into()],
                ..Person::default()
            };
            policy.handed_in(entry, Some(&person), &[])
        };
        let day = |id: &str, number: &str, login: &str| {
            let entry = entry("one", id, "one");
            match handed_in(&entry, id, Some(number), login) {
                Ok(Some(HandInTime::At(time))) => time.strftime("%d").to_string(),
                other => panic!("{id}: {other:?}"),
            }
        };
        assert_eq!(day("77", "2001", "bob"), "20");
        assert_eq!(day("78", "2002", "77"), "27");
        assert_eq!(day("79", "77", "eve"), "28");
        // The list has no id for this person, and the roster has her login in its place.
        assert_eq!(day("zoe", "2004", "zoe"), "19");
        let mut of_group = entry("one", "80", "one");
        of_group.signs = vec![Sign::Account {
            number: "2002".into(),
            name: "Team".into(),
            may_be_group: true,
        }];
        assert_eq!(handed_in(&of_group, "80", None, "ian"), Ok(None));

        fs::write(&path, "login,time\n77,2026-11-27 10:00\n").expect("there is room");
        policy.times = times_in(&path, Some(&TimeZone::UTC)).expect("it is a list of times");
        let entry = entry("one", "ada", "one");
        let of = |login: &str| {
            let logins = vec![login.into()];
            let id = "77".into();
            policy.handed_in(
                &entry,
                Some(&Person {
                    id,
                    logins,
                    ..Person::default()
                }),
                &[],
            )
        };
        assert!(of("bob") == Ok(None) && of("77") != Ok(None));
    }

    #[test]
    fn a_submission_named_like_somebody_elses_id_has_its_owners_time() {
        use crate::grade::class::marks::tests::entry;
        use crate::grade::intake::names::HandInTime;

        let folder = tempfile::tempdir().expect("there is room");
        let path = folder.path().join("times.csv");
        // Bob has left the course, and Eve has chosen his id for her login on GitHub.
        let list = "id,submission,time\nbob,,2026-11-19 10:00\neve,,2026-11-25 10:00\n\
            ada,,2026-11-20 10:00\nada,first,2026-11-18 10:00\n";
        fs::write(&path, list).expect("there is room");
        let policy = Policy {
            times: times_in(&path, Some(&TimeZone::UTC)).expect("it is a list of times"),
            ..Policy::default()
        };
        let day = |id: &str, name: &str| {
            let person = Person {
                id: id.into(),
                ..Person::default()
            };
            match policy.handed_in(&entry(name, id, name), Some(&person), &[]) {
                Ok(Some(HandInTime::At(time))) => time.strftime("%d").to_string(),
                other => panic!("{id}: {other:?}"),
            }
        };
        assert_eq!(day("eve", "bob"), "25");
        assert_eq!(day("ada", "first"), "18");
        assert_eq!(day("ada", "second"), "20");
    }

    #[test]
    fn no_time_in_a_name_is_too_late_to_count() {
        use crate::grade::class::marks::tests::entry;
        use crate::grade::intake::names::HandInTime;

        // Brightspace says November 25, and the uploader's name for the file looks like Blackboard's.
        let name = "11-23 - Ada - Nov 25, 2026 1100 PM - x_attempt_9999-12-31-23-59-59.zip";
        let at = Policy::default().handed_in(&entry("ada", "ada", name), None, &[]);
        assert_eq!(at, Ok(Some(HandInTime::At(Timestamp::MAX))));
    }

    #[test]
    fn late_days_are_spent_by_people_whose_id_looks_like_a_formula() {
        let folder = tempfile::tempdir().expect("there is room");
        let ids = ["ada", "-mal@example.org", "=eve;+1"];
        let lines = ids.map(|id| format!("{},2\n", printable_cell(id)));
        let of_nobody = ",0\n";
        let grades = format!("id,late_days\n{of_nobody}{}", lines.concat());
        fs::write(folder.path().join("grades.csv"), grades).expect("there is room");
        let rules = folder.path().join("policy.toml");
        let budget = "[late_days]\nbudget = 3\nspent = ['grades.csv', 'grades.csv']\n";
        let late = "[late]\npercent = 10\nper = 'day'\n";
        fs::write(
            folder.path().join("many.csv"),
            "id,late_days\nada,4294967295\n",
        )
        .expect("there is room");
        fs::write(
            &rules,
            format!("time_zone = 'UTC'\ndeadline = '2026-11-20 23:59'\n{late}{budget}"),
        )
        .expect("there is room");
        let policy = Policy::read(&rules, &assignment()).expect("it is a policy");
        assert_eq!(ids.map(|id| policy.late_days_left(id)), [1, 1, 1]);
        let person = |id: &str| Person {
            id: id.into(),
            ..Person::default()
        };
        let people = ids.map(person);
        assert_eq!(policy.strangers(&people), [""; 0]);
        assert_eq!(policy.strangers(&people[1..]), ["ada"]);
        let text = fs::read_to_string(&rules).expect("it was written");
        let text = text.replace("'grades.csv']", "'many.csv']");
        fs::write(&rules, text).expect("there is room");
        let policy = Policy::read(&rules, &assignment()).expect("it is a policy");
        assert_eq!(policy.late_days_left("ada"), 0);
    }

    #[test]
    fn extra_credit_for_a_part_that_does_not_exist_is_refused() {
        let folder = tempfile::tempdir().expect("there is room");
        let path = folder.path().join("policy.toml");
        let read = |parts: &str| {
            let rules = format!("[extra_credit]\nparts = {parts}\n");
            fs::write(&path, rules).expect("there is room");
            Policy::read(&path, &assignment())
        };
        read("['sphere', 'scenes']").expect("both exist");
        let error = read("['scenes', 'spere']").expect_err("it is misspelt");
        let error = error.to_string();
        assert!(error.contains("extra_credit.parts has `spere`"), "{error}");
    }
}
