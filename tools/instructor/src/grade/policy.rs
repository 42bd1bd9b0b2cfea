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
    let remedy = "correct it, or save it as a CSV file whose first line is: id,time";
    Table::read(path, "list of times", remedy, |table| {
        let who = WHO.iter();
        let who = who.filter_map(|(name, kind)| Some((*kind, table.column(&[name])?)));
        let who: Vec<(TimeKey, usize)> = who.collect();
        if who.is_empty() {
            table.needed_column(&WHO.map(|(name, _)| name))?;
        }
        let time = table.needed_column(&TIME)?;
        let of = |(line, row): &(u64, csv::StringRecord)| {
            let said = cell(row, time);
            let at = match said {
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
            Ok(TimeLine {
                keys,
                at,
                said: said.to_owned(),
            })
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
    let remedy = "correct it, or save it as a CSV file whose first line is: id,group";
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
mod tests;
