//! The submissions, and the people who handed them in.
//!
//! Reading order: [`reader`] reads folders and archives; [`source`] decides which of them contain a
//! class; [`hand_in`] collects each person's files, by the [`names`] that platforms give;
//! [`answers`] finds each person's answers, by [`task_names`]; [`roster`] reads the list of a
//! course's people, which is a [`table`]; [`index`] finds people in a text, by rules of [`matching`];
//! [`account`] finds a platform's people, and [`plain`] people by other names, by the [`pattern`] that
//! the instructor has given; and [`placement`] decides whose each submission is.

pub mod account;
pub mod answers;
pub mod hand_in;
pub mod index;
pub mod matching;
pub mod names;
pub mod pattern;
pub mod placement;
pub mod plain;
pub mod reader;
pub mod roster;
pub mod source;
pub mod table;
pub mod task_names;

use std::collections::{BTreeMap, BTreeSet};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use self::hand_in::HandIn;
use self::index::Index;
use self::matching::Proof;
use self::names::{Platform, PlatformName, Sign};
use self::pattern::NamePattern;
use self::reader::file_names;
use self::roster::Person;
use self::source::Source;
use super::provenance::{self, sha256};
use pinhole_course::assignment::{Assignment, Task, examples_file};
use pinhole_course::error::{Error, Result, ResultExt};
use pinhole_course::link;
use pinhole_course::submission::{Answer, AnswerFileProblem, Submission, text};

/// One submission as it was handed in.
#[derive(Clone, Debug, Deserialize, Serialize)]
pub struct Entry {
    /// Its folder in the results: a plain name that no other entry has.
    pub id: String,
    /// Its name as it was handed in.
    pub name: String,
    /// The names of its files and folders, which may say when it was handed in.
    #[serde(default)]
    pub given: Vec<String>,
    /// The platform that gave these names, if one did.
    #[serde(default)]
    pub platform: Option<Platform>,
    /// What these names say about the person who handed it in.
    pub signs: Vec<Sign>,
    /// The most that these names can prove.
    #[serde(default)]
    pub at_most: Proof,
    /// What had to be done to read it.
    pub notes: Vec<String>,
    /// Why the instructor should check how it was read.
    pub doubts: Vec<String>,
    /// The answer files that are missing or refused: one message for each problem.
    pub unusable: Vec<String>,
    /// The hashes of its answers, if they could be read: see
    /// [`Provenance::answers`](provenance::Provenance::answers). A mark that was given to other
    /// answers is not valid for this submission.
    #[serde(default)]
    pub answers: Option<Vec<(String, String)>>,
    /// Its answers, or why the machine could not read them.
    #[serde(skip, default = "not_read")]
    pub submission: std::result::Result<Submission, String>,
}

fn not_read() -> std::result::Result<Submission, String> {
    Err("it was not read".into())
}

impl Entry {
    /// What the same person's submission has in every run. Ids of similar names depend on what else
    /// was handed in.
    pub fn key(&self) -> &str {
        file_names::stem(&self.name)
    }

    /// Whether its names can be read as this platform's.
    pub fn is_of(&self, platform: Platform) -> bool {
        let read = self.given.iter().flat_map(|name| names::platforms(name));
        read.into_iter().any(|it| it.platform == platform)
    }

    /// The names that this platform gave to its files, if each can be read in one way only.
    pub fn named_by(&self, of: Platform) -> impl Iterator<Item = PlatformName<'_>> {
        let given = self.given.iter().filter(move |_| self.platform == Some(of));
        let names = given.filter_map(move |name| names::reading(name, Some(of)));
        names.filter(move |name| name.platform == of)
    }

    /// What its author should know about how it was read.
    pub fn remarks(&self) -> Vec<String> {
        [&self.notes[..], &self.doubts].concat()
    }
}

/// Two shards have graded the same class if these fields are equal. Answers may differ, because
/// they may have changed between the two runs.
impl PartialEq for Entry {
    fn eq(&self, other: &Entry) -> bool {
        let key = |entry: &Entry| (entry.id.clone(), entry.name.clone(), entry.signs.clone());
        key(self) == key(other)
    }
}

/// Everything that was found.
#[derive(Clone, Debug, Default)]
pub struct Intake {
    /// The submissions, by id.
    pub entries: Vec<Entry>,
    /// Files among the submissions that belong to no submission. They are listed, not silently
    /// dropped.
    pub ignored: Vec<String>,
    /// Uploads that are not graded, and the entry with a later upload.
    pub superseded: BTreeMap<String, String>,
    /// All paths, if any is a folder of submissions.
    pub passed: Vec<String>,
}

/// Finds the submissions in some paths. Each path is a submission, or a folder of submissions. `named`
/// says how folders and archives are named.
pub fn find(
    paths: &[PathBuf],
    assignment: &Assignment,
    people: Option<&[Person]>,
    named: Option<&NamePattern>,
) -> Result<Intake> {
    let index = Index::of(people.unwrap_or_default());
    let named = named.cloned().unwrap_or_default();
    let is_wanted = |name: &str| task_names::file_of(name, assignment).is_some();
    let is_answer =
        |name: &str| is_wanted(name) || names::platforms(name).iter().any(|it| is_wanted(it.rest));
    let mut sources = Vec::new();
    let mut intake = Intake::default();
    for path in paths {
        // A slash at its end would lead through a link.
        let path = &path.components().collect::<PathBuf>();
        // Perhaps it is mistyped, and the path of a class.
        path.symlink_metadata().or_input(
            format_args!("cannot read {}", path.display()),
            "name a submission, or a folder of submissions",
        )?;
        let read = link::refuse_input(path).and_then(|()| reader::read(path, &is_answer, &named));
        let found = match read {
            Ok(read) => read,
            Err(error) if paths.len() == 1 => return Err(error),
            // A student may have made it so that nobody is graded.
            Err(error) => {
                intake.ignored.push(error.problem);
                continue;
            }
        };
        let mut source = Source {
            name: name(path),
            is_archive: found.is_archive,
            is_wrapped: found.is_wrapped,
            is_only: paths.len() == 1,
            found: found.files,
            named: &named,
            index: &index,
        };
        source.unwrap();
        sources.push(source);
    }
    let are_classes = sources.iter().all(Source::is_class);
    if sources.iter().any(Source::is_class) {
        intake.passed = paths.iter().map(|path| real(path)).collect();
    }
    let mut handed_in = Vec::new();
    for source in sources {
        if source.is_class() {
            let (found, ignored) = source.of_class(are_classes);
            handed_in.extend(found);
            intake.ignored.extend(ignored);
        } else {
            handed_in.push(source.whole());
        }
    }
    if handed_in.is_empty() {
        return Err(Error::input(
            "the paths you gave contain no submission",
            "name folders that contain the answer files, or a folder of such folders",
        ));
    }
    let mut taken = BTreeSet::new();
    // A name that may stay as it is comes first, so nobody else gets an id like it.
    handed_in.sort_by_key(|it| plain(&it.name) != file_names::stem(&it.name));
    for one in handed_in {
        let entry = entry(one, assignment, &mut taken, &mut intake.superseded);
        intake.entries.push(entry);
    }
    doubt_twins(&mut intake.entries);
    intake.entries.sort_by(|a, b| a.id.cmp(&b.id));
    intake.ignored.sort();
    Ok(intake)
}

/// Lists submissions of the same name. One of them may be in a folder that somebody else has made.
fn doubt_twins(entries: &mut [Entry]) {
    let mut counts: BTreeMap<String, usize> = BTreeMap::new();
    for entry in &*entries {
        *counts.entry(entry.key().into()).or_default() += 1;
    }
    for entry in entries {
        if counts[entry.key()] > 1 {
            entry
                .doubts
                .push("another submission has the same name".into());
        }
    }
}

fn entry(
    one: HandIn,
    assignment: &Assignment,
    taken: &mut BTreeSet<String>,
    superseded: &mut BTreeMap<String, String>,
) -> Entry {
    let id = free_id(&plain(&one.name), taken);
    superseded.extend(
        one.superseded
            .into_iter()
            .map(|upload| (upload, id.clone())),
    );
    let read = || answers::choose(&one.name, &one.uploads, assignment);
    let choice = catch_unwind(AssertUnwindSafe(read));
    let choice = choice.unwrap_or_else(|_| Err("the grader itself failed to read it".into()));
    let mut entry = Entry {
        id,
        name: one.name,
        given: one.given,
        platform: one.platform,
        signs: one.signs,
        at_most: one.at_most,
        notes: Vec::new(),
        doubts: one.doubts,
        unusable: Vec::new(),
        answers: None,
        submission: not_read(),
    };
    match choice {
        Ok(choice) => {
            entry.unusable = unusable(&choice.submission, assignment);
            entry.notes = choice.notes;
            entry.doubts.extend(choice.doubts);
            entry.answers = Some(provenance::of_answers(&choice.submission));
            entry.submission = Ok(choice.submission);
        }
        Err(why) => entry.submission = Err(why),
    }
    entry
}

/// An id that nobody has, made from `wanted`. On some systems, two folder names can't differ in
/// capitals alone.
pub fn free_id(wanted: &str, taken: &mut BTreeSet<String>) -> String {
    let others = (2..).map(|count| format!("{wanted}.{count}"));
    let mut ids = std::iter::once(wanted.to_owned()).chain(others);
    let free = ids.find(|id| taken.insert(id.to_lowercase()));
    free.expect("only finitely many are taken")
}

/// The answer files without usable text, and why. Files with the same problem are named together.
fn unusable(submission: &Submission, assignment: &Assignment) -> Vec<String> {
    let mut found: Vec<(&AnswerFileProblem, Vec<String>)> = Vec::new();
    let answers = assignment
        .tasks
        .iter()
        .map(Task::file)
        .zip(&submission.answers);
    // Nobody needs to hand in examples.
    let examples = submission.examples.iter();
    let examples = examples.filter(|it| it.text != Err(AnswerFileProblem::Missing));
    let examples = examples.map(|it| (examples_file(&it.task), it));
    for (file, answer) in answers.chain(examples) {
        let Err(problem) = &answer.text else { continue };
        match found.iter_mut().find(|(other, _)| *other == problem) {
            Some((_, files)) => files.push(file),
            None => found.push((problem, vec![file])),
        }
    }
    let in_words = |(problem, files): (&AnswerFileProblem, Vec<String>)| {
        let verb = if files.len() == 1 { "is" } else { "are" };
        let files = files.join(", ");
        match problem {
            AnswerFileProblem::Missing => format!("{files} {verb} missing"),
            AnswerFileProblem::Refused(why) => format!("{files} {verb} refused: {why}"),
        }
    };
    found.into_iter().map(in_words).collect()
}

/// Where a path leads, for people to read. Different for different paths.
fn real(path: &Path) -> String {
    let absolute = path.canonicalize().unwrap_or(path.into());
    text::name(absolute.as_os_str().as_encoded_bytes())
}

/// A path's name, for people to read. It does not change if the path becomes a link meanwhile.
fn name(path: &Path) -> String {
    let real = path.canonicalize().unwrap_or_default();
    let name = path.file_name().or(real.file_name());
    text::name(name.unwrap_or_default().as_encoded_bytes())
}

/// The length at which names are cut.
const MOST_CHARACTERS: usize = 80;

/// A name that is safe for a folder on every system, and can't be mistaken for a command's
/// option. If it must change, it gets a hash, so that it stays unique.
fn plain(name: &str) -> String {
    let stem = file_names::stem(name);
    let is_plain = |c: char| c.is_ascii_alphanumeric() || "._-".contains(c);
    let safe: String = stem
        .chars()
        .map(|c| if is_plain(c) { c } else { '_' })
        .take(MOST_CHARACTERS)
        .collect();
    let safe = safe.trim_start_matches(['-', '.']).trim_end_matches('.');
    let safe = match is_device(safe) {
        true => format!("_{safe}"),
        false => safe.into(),
    };
    match safe == stem && !safe.is_empty() {
        true => safe,
        false => {
            let hash = &sha256(name.as_bytes())[..8];
            format!("{safe}-{hash}").trim_start_matches('-').into()
        }
    }
}

/// Whether Windows takes this name for a device, whatever follows the first dot.
fn is_device(name: &str) -> bool {
    let name = name.split('.').next().unwrap_or(name).to_ascii_uppercase();
    let port = name.strip_suffix(|c: char| c.is_ascii_digit());
    ["CON", "PRN", "AUX", "NUL"].contains(&name.as_str())
        || port.is_some_and(|port| ["COM", "LPT"].contains(&port))
}

/// A submission without any usable file.
pub fn without_answers(entry: &Entry, assignment: &Assignment) -> Submission {
    let answer = |task: &Task| Answer {
        task: task.name.clone(),
        text: Err(AnswerFileProblem::Missing),
    };
    Submission {
        folder: PathBuf::from(&entry.name),
        read_from: PathBuf::from(&entry.name),
        place: PathBuf::from(&entry.name),
        answers: assignment.tasks.iter().map(answer).collect(),
        examples: assignment.with_examples().map(answer).collect(),
    }
}

/// The share of shard `k` of `n`, counted from 1. It takes every n-th submission, so that slow
/// ones are spread evenly.
pub fn shard<T>(all: Vec<T>, shard: Option<(usize, usize)>) -> Vec<T> {
    let Some((k, n)) = shard else { return all };
    let mine = all
        .into_iter()
        .enumerate()
        .filter(|(at, _)| at % n == k - 1);
    mine.map(|(_, entry)| entry).collect()
}

#[cfg(test)]
mod tests;
