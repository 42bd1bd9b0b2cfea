//! All records of a class, and what changed when it was graded again.

pub mod concern;
pub mod marks;
pub mod replace;

use std::collections::{BTreeMap, BTreeSet, VecDeque};
use std::fs;
use std::path::Path;

use serde::{Deserialize, Serialize};

pub use super::cache::ROLL;

use self::concern::Concern;
use self::marks::Rows;
use super::intake::placement::{self, Placement};
use super::intake::roster::Person;
use super::intake::{self, Entry};
use super::policy::Policy;
use super::policy::mark::Mark;
use super::policy::times::TimeLine;
use super::record::{Record, RecordSummary, TaskSummary};
use super::shared_answers::{self, KnownAnswers, SharedAnswer, SharedPair};
use pinhole_course::error::{Result, ResultExt};
use pinhole_course::outcome::Status;

/// What was handed in, and by whom. Every shard has the same roll.
#[derive(Clone, Debug, Default, Deserialize, PartialEq, Serialize)]
pub struct Roll {
    /// Everything that is graded, by id.
    pub entries: Vec<Entry>,
    /// The roster, if there is one.
    pub people: Option<Vec<Person>>,
    pub placed: Placement,
    /// Files that are not submissions.
    pub ignored: Vec<String>,
    /// The folders and archives that the class was read from. Empty if the user passed only single
    /// submissions.
    #[serde(default)]
    pub passed: Vec<String>,
    /// How judged points become final marks.
    #[serde(default)]
    pub policy: Option<Policy>,
    /// The answers that submissions of a name had when the table of times was passed first, if they
    /// have others now: see [`Roll::note_changes`].
    pub changed: BTreeMap<String, Vec<Answers>>,
}

/// See [`Entry::answers`].
type Answers = Option<Vec<(String, String)>>;

impl Roll {
    /// Reads the roll of a class that was graded into a folder.
    pub fn read(path: &Path) -> Result<Roll> {
        let text = fs::read_to_string(path).or_input(
            format_args!("cannot read {}", path.display()),
            "name a folder that `pinhole grade` has written",
        )?;
        serde_json::from_str(&text).or_input(
            format_args!("{}", path.display()),
            "grade that class again with this version of Pinhole",
        )
    }

    /// Whether another roll has the same submissions, roster and policy. They may have been read from
    /// other paths.
    pub fn has_same_submissions(&self, other: &Roll) -> bool {
        let here = Roll {
            passed: other.passed.clone(),
            changed: other.changed.clone(),
            ..self.clone()
        };
        here == *other
    }

    /// The keys of its submissions.
    pub fn keys(&self) -> BTreeSet<&str> {
        self.entries.iter().map(Entry::key).collect()
    }

    /// Gives single submissions the ids that submissions of their names have in a class, or else ids
    /// that are free there.
    pub fn take_ids_of(&mut self, class: &Roll) {
        let mut old: BTreeMap<&str, VecDeque<&String>> = BTreeMap::new();
        let mut taken = BTreeSet::new();
        for entry in &class.entries {
            old.entry(entry.key()).or_default().push_back(&entry.id);
            taken.insert(entry.id.to_lowercase());
        }
        let mut renamed = BTreeMap::new();
        for entry in &mut self.entries {
            let same = old.get_mut(entry.key());
            let id = match same.and_then(VecDeque::pop_front) {
                Some(id) => id.clone(),
                None => intake::free_id(&entry.id, &mut taken),
            };
            renamed.insert(std::mem::replace(&mut entry.id, id.clone()), id);
        }
        for id in self.placed.superseded.values_mut() {
            id.clone_from(&renamed[id]);
        }
    }

    /// Adds single submissions to the class that was graded into the same folder before. They
    /// replace earlier ones of the same name, and all others stay.
    pub fn into_class(self, mut class: Roll) -> Roll {
        let new = self.keys();
        let old = class.clone();
        class.entries.retain(|entry| !new.contains(entry.key()));
        class.entries.extend(self.entries);
        class.entries.sort_by(|a, b| a.id.cmp(&b.id));
        class.people = self.people.or(class.people);
        class.ignored.extend(self.ignored);
        class.ignored.sort();
        class.ignored.dedup();
        class.placed.superseded.extend(self.placed.superseded);
        class.policy = self.policy.or(class.policy);
        class.changed.clear();
        class.note_changes(&old);
        class.place();
        class
    }

    /// The lines of the table of times; none without a table.
    pub fn times(&self) -> &[TimeLine] {
        self.policy.as_ref().map_or(&[], |policy| &policy.times)
    }

    /// Notes which submissions are new, or have other answers than in the class that was graded into
    /// the same folder before. If the table of times is still the same, it may say when the earlier
    /// answers were handed in.
    pub fn note_changes(&mut self, class: &Roll) {
        if self.times() != class.times() {
            return;
        }
        let mut old = class.answers();
        old.extend(class.changed.clone());
        for (key, answers) in self.answers() {
            let old = old.remove(&key).unwrap_or_default();
            if old != answers {
                self.changed.entry(key).or_insert(old);
            }
        }
    }

    /// The answers of all submissions of each name.
    fn answers(&self) -> BTreeMap<String, Vec<Answers>> {
        let mut answers: BTreeMap<String, Vec<Answers>> = BTreeMap::new();
        for entry in &self.entries {
            let of_name = answers.entry(entry.key().into()).or_default();
            of_name.push(entry.answers.clone());
            of_name.sort();
        }
        answers
    }

    /// Finds each submission's person, and the people for whom nothing was handed in, not even by
    /// their group.
    pub fn place(&mut self) {
        if let (Some(policy), Some(people)) = (&self.policy, &mut self.people) {
            know_groups(policy, people);
        }
        let superseded = std::mem::take(&mut self.placed.superseded);
        self.placed = placement::place(&self.entries, self.people.as_deref());
        self.placed.superseded = superseded;
        let mut missing = std::mem::take(&mut self.placed.missing);
        let handed_in = self.handed_in();
        missing.retain(|person| !handed_in.contains(person.id.as_str()));
        self.placed.missing = missing;
    }

    /// The ids of the people who have handed something in, alone or with a group.
    fn handed_in(&self) -> BTreeSet<&str> {
        let of = self.placed.of.values();
        let people = of.flat_map(|person| self.team_of(person));
        people.map(|person| person.id.as_str()).collect()
    }

    /// People who may have handed in a submission whose owner is uncertain, and whose group has
    /// handed in nothing else.
    pub fn in_doubt(&self) -> Vec<&Person> {
        let handed_in = self.handed_in();
        let mut people = self.placed.in_doubt();
        people.retain(|person| !handed_in.contains(person.id.as_str()));
        people
    }

    /// Everyone who gets the mark for what a person hands in: the person alone, or the person's
    /// group.
    pub fn team_of<'a>(&'a self, person: &'a Person) -> Vec<&'a Person> {
        let policy = self.policy.as_ref();
        let Some(group) = policy.and_then(|policy| policy.group_of(&person.id)) else {
            return vec![person];
        };
        let people = self.people.iter().flatten();
        people
            .filter(|other| group.members.contains(&other.id))
            .collect()
    }
}

/// Lets a submission with the name of a group count as handed in by one of its members.
pub fn know_groups(policy: &Policy, people: &mut [Person]) {
    people.iter_mut().for_each(|person| person.group = None);
    for group in &policy.groups {
        let mut all = people.iter_mut();
        if let Some(person) = all.find(|person| group.members.contains(&person.id)) {
            person.group = Some(group.name.clone());
        }
    }
}

/// A graded class.
pub struct Class<'a> {
    pub title: String,
    pub roll: &'a Roll,
    /// The rows, in the order of the roll.
    pub rows: Vec<Row<'a>>,
    /// Additional rows, for people whose group handed something in for them.
    pub shared: Vec<Row<'a>>,
    /// What the instructor should look at, the most serious first.
    pub concerns: Vec<Concern>,
    pub alike: Vec<SharedAnswer>,
    /// Pairs that share several answers.
    pub pairs: Vec<SharedPair>,
    records: &'a BTreeMap<String, RecordSummary>,
}

/// A submission's row, for one person.
#[derive(Clone)]
pub struct Row<'a> {
    pub entry: &'a Entry,
    pub person: Option<&'a Person>,
    pub record: Option<&'a RecordSummary>,
    /// The mark; `None` if there is none, or if another submission counts.
    pub mark: Option<Mark>,
    /// Why another submission counts.
    pub not_counted: Option<String>,
    /// Whether another member of the person's group handed it in.
    pub is_shared: bool,
}

/// A belief, and the submissions that seem to hold it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SharedBelief {
    pub mistake: String,
    pub belief: String,
    pub tasks: Vec<String>,
    pub who: Vec<String>,
}

impl<'a> Class<'a> {
    /// A class of these records, by id.
    pub fn new(
        title: &str,
        roll: &'a Roll,
        records: &'a BTreeMap<String, RecordSummary>,
        known: &KnownAnswers,
    ) -> Class<'a> {
        let Rows {
            own,
            shared,
            concerns,
        } = marks::rows(roll, records);
        // Compare only submissions that count, because several attempts by one person are alike
        // anyway.
        let counted = own.iter().filter(|row| row.not_counted.is_none());
        let all: Vec<&RecordSummary> = counted.filter_map(|row| row.record).collect();
        let alike = known.shared_answers(&all);
        let without_numbers = concern::without_numbers(&own).into_iter().collect();
        Class {
            title: title.into(),
            roll,
            pairs: shared_answers::pairs(&alike),
            alike,
            rows: own,
            shared,
            concerns: concern::sorted([roll.concerns(), concerns, without_numbers].concat()),
            records,
        }
    }

    /// Every row: one for each submission, then those of group members.
    pub fn all_rows(&self) -> impl Iterator<Item = &Row<'a>> {
        self.rows.iter().chain(&self.shared)
    }

    /// Everyone's mark, once.
    pub fn gradebook(&self) -> impl Iterator<Item = (&'a Person, &Mark, &Row<'a>)> {
        let rows = self.all_rows();
        rows.filter_map(|row| Some((row.person?, row.mark.as_ref()?, row)))
    }

    /// The records that have a mark.
    pub fn graded(&self) -> impl Iterator<Item = &'a RecordSummary> {
        let records = self.rows.iter().filter_map(|row| row.record);
        records.filter(|record| record.is_graded())
    }

    /// Whether a submission has a mark.
    pub fn is_graded(&self, id: &str) -> bool {
        self.records.get(id).is_some_and(RecordSummary::is_graded)
    }

    /// What the records were judged on, each listed once.
    pub fn judged_on(&self) -> Vec<&'a str> {
        let all = self.graded();
        let mut all: Vec<&str> = all.map(|record| record.judged_on.as_str()).collect();
        all.sort();
        all.dedup();
        all
    }

    /// The submissions without a mark, and why.
    pub fn not_graded(&self) -> Vec<(&'a str, &'a str)> {
        let without = self.rows.iter().filter_map(|row| match row.record {
            Some(record) if record.is_graded() => None,
            Some(record) => Some((row.entry.id.as_str(), record.explanation.as_str())),
            None => Some((
                row.entry.id.as_str(),
                "it has not been graded yet; run `pinhole grade` again",
            )),
        });
        without.collect()
    }

    /// The submissions, by status.
    pub fn outcomes(&self) -> BTreeMap<Status, Vec<&'a str>> {
        let mut outcomes: BTreeMap<Status, Vec<&str>> = BTreeMap::new();
        for row in &self.rows {
            let status = row.record.map_or(Status::NotGraded, |record| record.status);
            outcomes.entry(status).or_default().push(&row.entry.id);
        }
        outcomes
    }

    /// The mistakes in the submissions, the most common first.
    pub fn mistakes(&self) -> Vec<SharedBelief> {
        let mut held: BTreeMap<&str, SharedBelief> = BTreeMap::new();
        for record in self.graded() {
            for TaskSummary { task, mistakes, .. } in &record.tasks {
                for (mistake, belief) in mistakes {
                    let entry = held.entry(mistake).or_insert_with(|| SharedBelief {
                        mistake: mistake.clone(),
                        belief: belief.clone(),
                        tasks: Vec::new(),
                        who: Vec::new(),
                    });
                    if entry.tasks.iter().all(|name| **name != *task.name) {
                        entry.tasks.push(task.name.to_string());
                    }
                    if entry.who.last() != Some(&record.id) {
                        entry.who.push(record.id.clone());
                    }
                }
            }
        }
        let mut held: Vec<SharedBelief> = held.into_values().collect();
        held.sort_by(|a, b| (b.who.len(), &a.mistake).cmp(&(a.who.len(), &b.mistake)));
        held
    }

    /// The slowest submissions, with their times in seconds.
    pub fn slowest(&self) -> Vec<(&'a str, f64)> {
        let times = self
            .graded()
            .map(|record| (record.id.as_str(), record.seconds));
        let mut times: Vec<(&str, f64)> = times.collect();
        times.sort_by(|a, b| b.1.total_cmp(&a.1));
        times.truncate(10);
        times
    }
}

/// A mark that has changed.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Change {
    pub id: String,
    pub before: u32,
    pub after: u32,
    /// The tasks and scenes whose points changed, with the old and the new points.
    pub parts: Vec<(String, u32, u32)>,
    /// Whether the answers themselves have changed.
    pub answers_changed: bool,
}

impl Change {
    /// How `after` differs from `before`; `None` if all points are the same.
    pub fn between(before: &Record, after: &Record) -> Option<Change> {
        let parts = |record: &Record| {
            let tasks = record.got.tasks.iter();
            let tasks = tasks.map(|task| (task.name.clone(), task.points));
            let scenes = ("scenes".to_owned(), record.scene_points().0);
            tasks.chain([scenes]).collect::<Vec<_>>()
        };
        let (Some(points), Some(now)) = (before.got.points, after.got.points) else {
            return None;
        };
        let old = parts(before);
        let had = |name: &String| old.iter().find(|(other, _)| other == name);
        let changed = parts(after).into_iter().filter_map(|(name, now)| {
            let had = had(&name).map_or(0, |(_, points)| *points);
            (had != now).then_some((name, had, now))
        });
        let parts: Vec<(String, u32, u32)> = changed.collect();
        (points != now || !parts.is_empty()).then(|| Change {
            id: after.id.clone(),
            before: points,
            after: now,
            parts,
            answers_changed: before.provenance.answers != after.provenance.answers,
        })
    }

    /// The change, in one line.
    pub fn in_words(&self) -> String {
        let parts = self
            .parts
            .iter()
            .map(|(name, had, has)| format!("{name} {had} → {has}"));
        let parts: Vec<String> = parts.collect();
        let same = match self.answers_changed {
            true => "",
            false => ", from the same answers",
        };
        let (before, after) = (self.before, self.after);
        format!(
            "{}: {before} → {after} ({}){same}",
            self.id,
            parts.join(", ")
        )
    }
}

/// Sorts changes: the largest losses first, because students ask about those.
pub fn sort_changes(changes: &mut [Change]) {
    let gain = |change: &Change| i64::from(change.after) - i64::from(change.before);
    changes.sort_by(|a, b| (gain(a), &a.id).cmp(&(gain(b), &b.id)));
}
