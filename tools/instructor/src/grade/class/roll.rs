//! What was handed in, and by whom.

use std::collections::{BTreeMap, BTreeSet, VecDeque};
use std::fs;
use std::path::Path;

use serde::{Deserialize, Serialize};

use crate::grade::intake::index::once;
use crate::grade::intake::pattern::NamePattern;
use crate::grade::intake::placement::{self, Placement};
use crate::grade::intake::roster::Person;
use crate::grade::intake::{self, Entry};
use crate::grade::policy::Policy;
use crate::grade::policy::times::TimeLine;
use pinhole_course::error::{Result, ResultExt};

/// What was handed in, and by whom. Every shard has the same roll.
#[derive(Clone, Debug, Default, Deserialize, PartialEq, Serialize)]
pub struct Roll {
    /// The name of the assignment.
    pub assignment: String,
    /// Everything that is graded, by id.
    pub entries: Vec<Entry>,
    /// The roster, if there is one.
    pub people: Option<Vec<Person>>,
    /// How folders and archives are named, if the user has said so.
    #[serde(default)]
    pub named: Option<NamePattern>,
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
    /// The lines of all tables of times that were passed, each with the submissions that it counted for
    /// when it was passed first, and their answers.
    #[serde(default)]
    pub timed: Vec<(TimeLine, BTreeMap<String, Vec<Answers>>)>,
    /// The answers of submissions that were passed alone after the class, by their names: several if
    /// nobody knows which are the newest, because they were passed to several folders.
    #[serde(default)]
    pub alone: BTreeMap<String, BTreeSet<Vec<Answers>>>,
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
            timed: other.timed.clone(),
            alone: other.alone.clone(),
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
        // If the whole class is passed again, as by `class/*`, its answers needn't be the newest.
        let is_whole = old.keys().is_subset(&new) && self.entries.len() > 1;
        for (key, answers) in self.answers().into_iter().filter(|_| !is_whole) {
            let alone = class.alone.entry(key).or_default();
            if self.entries.len() == 1 {
                alone.clear();
            }
            alone.insert(answers);
        }
        class.entries.retain(|entry| !new.contains(entry.key()));
        class.entries.extend(self.entries);
        class.entries.sort_by(|a, b| a.id.cmp(&b.id));
        class.people = self.people.or(class.people);
        class.named = self.named.or(class.named);
        class.ignored.extend(self.ignored);
        class.ignored.sort();
        class.ignored.dedup();
        class.placed.superseded.extend(self.placed.superseded);
        class.policy = self.policy.or(class.policy);
        class.doubt_earlier_answers();
        class.place();
        class.note_times();
        class
    }

    /// Remembers what was passed alone after another run for the same class.
    pub fn remember_alone(&mut self, other: &Roll) {
        for (key, all) in &other.alone {
            let own = self.alone.entry(key.clone()).or_default();
            own.extend(all.iter().cloned());
        }
    }

    /// Lists the submissions that were passed alone after the class, with other answers than now. What
    /// was passed alone is probably newer.
    pub fn doubt_earlier_answers(&mut self) {
        let own = self.answers();
        self.alone.retain(|key, _| own.contains_key(key));
        for entry in &mut self.entries {
            let why = "its answers are not those that you passed alone after the class: put the ones that \
                       count into the class's folder, or pass them alone again";
            let mut alone = self.alone.get(entry.key()).into_iter().flatten();
            let is_other = alone.any(|it| *it != own[entry.key()]);
            if is_other && !entry.doubts.iter().any(|it| it == why) {
                entry.doubts.push(why.into());
            }
        }
    }

    /// The lines of the table of times; none without a table.
    pub fn times(&self) -> &[TimeLine] {
        self.policy.as_ref().map_or(&[], |policy| &policy.times)
    }

    /// Remembers the tables of times of another run for the same class. If a line counted for other
    /// answers there, nobody knows which it is about.
    pub fn remember_times(&mut self, other: &Roll) {
        for (line, of) in &other.timed {
            match self.timed.iter_mut().find(|(own, _)| own.is_same(line)) {
                Some((_, own)) => own.retain(|key, answers| of.get(key) == Some(answers)),
                None => self.timed.push((line.clone(), of.clone())),
            }
        }
    }

    /// Notes which answers the new lines of the table of times count for.
    pub fn note_times(&mut self) {
        let answers = self.answers();
        let counted = self.entries.iter().map(|entry| self.line_of(entry));
        let counted: Vec<_> = counted.zip(&self.entries).collect();
        let mut new = Vec::new();
        for line in self.times() {
            if self.timed.iter().any(|(known, _)| known.is_same(line)) {
                continue;
            }
            let of = counted.iter().filter(|(its, _)| *its == Some(line));
            let of = of.map(|(_, entry)| (entry.key().into(), answers[entry.key()].clone()));
            new.push((line.clone(), of.collect()));
        }
        self.timed.extend(new);
    }

    fn line_of(&self, entry: &Entry) -> Option<&TimeLine> {
        let people = self.people.as_deref().unwrap_or_default();
        let person = self.placed.of.get(&entry.id);
        self.policy.as_ref()?.line_of(entry, person, people)
    }

    /// The submissions whose line in the table of times was passed before, for other answers or for
    /// none. It may say when earlier ones were handed in.
    pub fn with_old_times(&self) -> Vec<&Entry> {
        let answers = self.answers();
        let is_old = |entry: &&Entry| {
            let line = self.line_of(entry);
            let known = self.timed.iter();
            let known = known.filter(|(known, _)| line.is_some_and(|line| line.is_same(known)));
            let key = entry.key();
            known
                .map(|(_, of)| of.get(key))
                .any(|of| of != Some(&answers[key]))
        };
        self.entries.iter().filter(is_old).collect()
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
        let named = self.named.clone().unwrap_or_default();
        self.placed = placement::place(&self.entries, self.people.as_deref(), &named);
        self.placed.superseded = superseded;
        let mut missing = std::mem::take(&mut self.placed.missing);
        let handed_in = self.handed_in();
        let in_doubt = self.in_doubt();
        missing.retain(|it| !handed_in.contains(it.id.as_str()) && !in_doubt.contains(&it));
        self.placed.missing = missing;
    }

    /// The ids of the people who have handed something in, alone or with a group.
    fn handed_in(&self) -> BTreeSet<&str> {
        let of = self.placed.of.values();
        let people = of.flat_map(|person| self.team_of(person));
        people.map(|person| person.id.as_str()).collect()
    }

    /// People who may have handed in a submission whose owner is uncertain, and their groups, if they
    /// have handed in nothing else.
    pub fn in_doubt(&self) -> Vec<&Person> {
        let handed_in = self.handed_in();
        let people = self.placed.in_doubt().into_iter();
        let mut people = once(people.flat_map(|it| self.team_of(it)));
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
