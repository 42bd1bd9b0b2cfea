//! Examples: public questions whose answers a student has worked out, and how many known mistakes
//! they would catch.
//!
//! This finds out whether a student has understood a task before any code exists (Wrenn and
//! Krishnamurthi, Executable Examples for Programming Problem Comprehension, ICER 2019). What each
//! mistake answers is read from its fingerprint. Its sample holds the first wrong questions in the
//! scattered order, so the first [`MOST_SAMPLED`] questions in that order are known for every
//! mistake. Public questions can be chosen only among these.

mod file;
mod handed_in;
mod own;

use std::collections::{BTreeMap, BTreeSet};
use std::panic::resume_unwind;
use std::path::Path;
use std::thread;

use pinhole::Fact;
use pinhole::comparison::channel_names;
use pinhole::film::{BOX_CHANNELS, HIT_CHANNELS, MISS, RAY_CHANNELS};
use pinhole::kind::Questions;
use serde::Serialize;

use crate::assignment::{Assignment, GroupPoints, Task};
use crate::checkout::Checkout;
use crate::diagnosis::fingerprint::{Fingerprint, MOST_SAMPLED, scattered};
use crate::error::{Error, Result, ResultExt};
use crate::goldens::Goldens;
use crate::goldens::questions::QuestionFilm;
use crate::submission::{AnswerFileProblem, text};
pub use file::new_file;
use file::{Entry, File};
pub use handed_in::add_handed_in;
use own::OwnQuestions;

#[cfg(test)]
mod tests;

/// How many significant digits an answer needs. It may be off by the judge's tolerance plus half a
/// unit of the last of them, counted from the first digit of the largest component of its vector.
const ENOUGH_DIGITS: f64 = 3.0;

/// The group of the questions that a student has written. No group of an assignment has a space in
/// its name.
const OWN: &str = "own ray";

/// How many digits of a question's numbers are shown. They change a number less than a film does,
/// which holds it in single precision.
const DIGITS: usize = 8;

/// The parts of an answer that an example may give, and the channels that hold them.
const PARTS: [(&str, &[&str]); 7] = [
    ("object", HIT_CHANNELS.split_at(1).0),
    ("t", HIT_CHANNELS.split_at(1).1.split_at(1).0),
    ("normal", HIT_CHANNELS.split_at(2).1),
    ("origin", RAY_CHANNELS.split_at(3).0),
    ("direction", RAY_CHANNELS.split_at(3).1),
    ("min", BOX_CHANNELS.split_at(3).0),
    ("max", BOX_CHANNELS.split_at(3).1),
];

/// The verdict on a file of examples.
#[derive(Debug, Serialize)]
pub struct JudgedExamples {
    /// The task that they are about.
    pub task: String,
    /// In the file's order.
    pub examples: Vec<JudgedExample>,
    /// How many known mistakes give another answer to one of the right examples.
    pub caught: usize,
    /// How many known mistakes examples of this task can catch.
    pub mistakes: usize,
}

/// The verdict on one example.
#[derive(Debug, Serialize)]
pub struct JudgedExample {
    /// The group of questions.
    pub group: String,
    /// The question, counted from 0.
    pub question: usize,
    /// Whether its answer is right.
    pub verdict: Verdict,
    /// The parts of its answer that are wrong.
    pub wrong: Vec<&'static str>,
    /// The question in words.
    pub asked: Vec<Fact>,
}

/// Whether an example is right.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Verdict {
    /// Mitsuba gives this answer too.
    Right,
    /// It gives another answer.
    Wrong,
    /// The example has no answer yet.
    Unanswered,
}

impl JudgedExamples {
    /// How many examples have this verdict.
    pub fn count(&self, verdict: Verdict) -> usize {
        let same = |example: &&JudgedExample| example.verdict == verdict;
        self.examples.iter().filter(same).count()
    }
}

/// What an example says about the answer.
struct Claim {
    /// Whether anything is hit; `None` if that is not asked.
    hit: Option<bool>,
    /// Parts, and the number in each of their channels.
    parts: Vec<(&'static str, Vec<f64>)>,
}

/// The questions of a group that examples may be about.
struct Asked<'a> {
    film: QuestionFilm,
    channels: Vec<String>,
    /// The parts of an answer, and the places of their channels.
    parts: Vec<(&'static str, Vec<usize>)>,
    /// Their places in the film, in the order in which examples count them.
    places: Vec<usize>,
    prints: Vec<(&'a str, Fingerprint)>,
}

/// Judges the examples in a file.
///
/// # Errors
/// If the file can't be read, or names what does not exist, or has rays of its own and there is no
/// Mitsuba.
pub fn judge_file(
    path: &Path,
    assignment: &Assignment,
    checkout: &Checkout,
) -> Result<JudgedExamples> {
    let remedy = "name a file that can be read, or write one: cargo pinhole examples --new TASK";
    // It may be a student's, and an instructor may judge it.
    let text = text::read(path)?.map_err(|problem| {
        let why = match problem {
            AnswerFileProblem::Missing => "there is no such file".into(),
            AnswerFileProblem::Refused(why) => why,
        };
        Error::input(format!("{}: {why}", path.display()), remedy)
    })?;
    judge((path, &text), assignment, checkout, true)
}

/// The stack that the most deeply nested TOML takes: 80 tables in a row, each below 80 keys.
const STACK: usize = 512 << 20;

/// Judges examples, given what their file is called and its text. Progress is shown if someone waits
/// for the result (`interactive`).
fn judge(
    file: (&Path, &str),
    assignment: &Assignment,
    checkout: &Checkout,
    interactive: bool,
) -> Result<JudgedExamples> {
    thread::scope(|scope| {
        let judge = || judge_here(file, assignment, checkout, interactive);
        let thread = thread::Builder::new().stack_size(STACK);
        let thread = thread.spawn_scoped(scope, judge).or_environment(
            "cannot start a thread",
            "free some memory, and run this again",
        )?;
        thread.join().unwrap_or_else(|panic| resume_unwind(panic))
    })
}

fn judge_here(
    (path, text): (&Path, &str),
    assignment: &Assignment,
    checkout: &Checkout,
    interactive: bool,
) -> Result<JudgedExamples> {
    let wrong = Error::input(
        path.display().to_string(),
        "correct the file; `cargo pinhole examples` shows how it should look",
    );
    let file: File = toml::from_str(text).or_fail(&wrong)?;
    let at = |place: usize, error: Error| {
        let line = text[..place].matches('\n').count() + 1;
        let problem = format!("{}:{line}: {}", path.display(), error.problem);
        Error::input(problem, error.remedy)
    };
    let task = find_task(file.task.get_ref(), assignment);
    let task = task.map_err(|error| at(file.task.span().start, error))?;
    let goldens = Goldens::read(&assignment.golden(), assignment)?;
    let mut own = 0;
    let mut questions = Vec::new();
    for entry in &file.example {
        let question = entry.get_ref().question(&mut own);
        questions.push(question.map_err(|error| at(entry.span().start, error))?);
    }
    let answer = || {
        let file = (path, text, &file.example[..]);
        OwnQuestions::answer(file, task, assignment, checkout, interactive)
    };
    let own_questions = (own > 0).then(answer).transpose()?;
    let mut all = BTreeMap::new();
    for group in groups(task) {
        let name = group.group.as_str();
        all.insert(name, Asked::read(&goldens, task, name)?);
    }
    if let Some(own) = &own_questions {
        all.insert(OWN, Asked::read(&own.goldens, task, OWN)?);
    }
    let mut examples = Vec::new();
    let mut caught = BTreeSet::new();
    for (entry, question) in file.example.iter().zip(questions) {
        let judged = entry.get_ref().judge(question, &all);
        let (example, claim, asked) = judged.map_err(|error| at(entry.span().start, error))?;
        if example.verdict == Verdict::Right {
            caught.extend(asked.caught(asked.places[example.question], &claim));
        }
        examples.push(example);
    }
    let mut mistakes = BTreeSet::new();
    for asked in all.values() {
        for place in &asked.places {
            mistakes.extend(asked.caught(*place, &asked.right_answer(*place)));
        }
    }
    Ok(JudgedExamples {
        task: task.name.clone(),
        examples,
        caught: caught.len(),
        mistakes: mistakes.len(),
    })
}

/// The groups of a task that examples may be about. Scenes may be withheld.
fn groups(task: &Task) -> impl Iterator<Item = &GroupPoints> {
    let groups = task.points.iter();
    groups.filter(|points| !task.is_of_scenes(&points.group))
}

fn find_task<'a>(name: &str, assignment: &'a Assignment) -> Result<&'a Task> {
    let tasks = assignment.tasks.iter();
    let names: Vec<&str> = tasks.map(|task| task.name.as_str()).collect();
    assignment.task(name).ok_or_else(|| {
        Error::input(
            format!("there is no task `{name}`"),
            format!("name one of: {}", names.join(", ")),
        )
    })
}

impl Entry {
    /// The verdict on an example, and the questions of its group.
    fn judge<'a, 'b>(
        &self,
        (group, question): (&str, usize),
        all: &'b BTreeMap<&str, Asked<'a>>,
    ) -> Result<(JudgedExample, Claim, &'b Asked<'a>)> {
        let asked = all.get(group).ok_or_else(|| {
            let names: Vec<&str> = all.keys().copied().collect();
            Error::input(
                format!("`{group}` is not a group of public questions"),
                format!("name one of: {}", names.join(", ")),
            )
        })?;
        let place = asked.places.get(question).copied();
        let place = place.ok_or_else(|| {
            Error::input(
                format!("`{group}` has no question {question}"),
                format!("choose one from 0 to {}", asked.places.len().max(1) - 1),
            )
        })?;
        let claim = self.claim(asked)?;
        let right = |channel: usize| asked.golden(channel, place);
        let wrong = asked.contradictions(place, &claim, &right);
        let verdict = match (
            claim.hit.is_none() && claim.parts.is_empty(),
            wrong.is_empty(),
        ) {
            (true, _) => Verdict::Unanswered,
            (false, true) => Verdict::Right,
            (false, false) => Verdict::Wrong,
        };
        let example = JudgedExample {
            group: group.into(),
            question,
            verdict,
            wrong,
            asked: asked.describe(place),
        };
        Ok((example, claim, asked))
    }
}

impl<'a> Asked<'a> {
    fn read(goldens: &'a Goldens, task: &Task, group: &str) -> Result<Asked<'a>> {
        let film = goldens.probe(task, group)?;
        let name = goldens.film_name(&film.golden_path);
        let mut prints = goldens
            .known
            .fingerprints(&name, &film.golden, &goldens.folder)?;
        prints.retain(|(slug, _)| {
            let mistake = &goldens.known.mistake[*slug];
            mistake.is_single() && mistake.fails.contains(&task.name)
        });
        let pixels = 0..film.resolution.pixels();
        let mut places: Vec<usize> = pixels.filter(|at| !film.golden.is_exempt(*at)).collect();
        // The student's own questions are at most as many, and keep the order of the file.
        if group != OWN {
            places.sort_by_key(|place| scattered(*place));
        }
        places.truncate(MOST_SAMPLED);
        let channels = channel_names(&film.golden);
        let place = |name: &&str| channels.iter().position(|own| own == name);
        let parts = PARTS.iter().filter_map(|(part, names)| {
            let places: Option<Vec<usize>> = names.iter().map(place).collect();
            Some((*part, places?))
        });
        let ids = film.golden.film().channel(HIT_CHANNELS[0]);
        let is_asked = |part: &str| match part {
            // A question about a single object does not ask for the object's number.
            "object" => ids.is_some_and(|ids| ids.iter().any(|id| *id > 0.0)),
            // Only questions about a shape give enough information to work out its normals.
            "normal" => task.shape.is_some(),
            _ => true,
        };
        let parts: Vec<_> = parts.filter(|(part, _)| is_asked(part)).collect();
        match parts.is_empty() {
            false => Ok(Asked {
                film,
                channels,
                parts,
                places,
                prints,
            }),
            true => Err(Error::input(
                format!(
                    "`{}` has no examples, because its questions have many right answers",
                    task.name
                ),
                "choose another task",
            )),
        }
    }

    fn questions(&self) -> Option<&Questions> {
        self.film.job.questions()
    }

    fn describe(&self, place: usize) -> Vec<Fact> {
        let questions = self.questions();
        let describe = |it: &Questions| it.describe(place, &self.film.name, DIGITS);
        questions.map(describe).unwrap_or_default()
    }

    fn golden(&self, channel: usize, place: usize) -> f32 {
        let golden = self.film.golden.film().channel(&self.channels[channel]);
        golden.unwrap_or_default()[place]
    }

    /// The place of the channel that says which object is hit.
    fn id(&self) -> Option<usize> {
        self.channels
            .iter()
            .position(|name| name == HIT_CHANNELS[0])
    }

    fn right_answer(&self, place: usize) -> Claim {
        let hit = self.id().map(|id| self.golden(id, place) != MISS);
        let number = |channel: &usize| f64::from(self.golden(*channel, place));
        let parts = self.parts.iter();
        let parts = parts.map(|(part, it)| (*part, it.iter().map(number).collect()));
        Claim {
            hit,
            parts: match hit {
                Some(false) => Vec::new(),
                _ => parts.collect(),
            },
        }
    }

    /// Which parts of a claim differ from an answer, given channel by channel.
    fn contradictions(
        &self,
        place: usize,
        claim: &Claim,
        answer: &dyn Fn(usize) -> f32,
    ) -> Vec<&'static str> {
        let is_hit = self.id().map(|id| answer(id) != MISS);
        if claim.hit.is_some() && claim.hit != is_hit {
            return vec!["hit"];
        }
        let mut wrong = Vec::new();
        for (part, channels) in &self.parts {
            let Some((_, numbers)) = claim.parts.iter().find(|(own, _)| own == part) else {
                continue;
            };
            let size = numbers.iter().fold(0.0, |size: f64, it| size.max(it.abs()));
            let slack = match *part {
                "object" => 0.0,
                _ => 0.5 * 10_f64.powf(size.log10().floor() + 1.0 - ENOUGH_DIGITS),
            };
            let is_right = |(channel, number): (&usize, &f64)| {
                let tolerance = self.film.golden.tolerance();
                let tolerance = tolerance.channel(&self.channels[*channel]);
                let allowed = f64::from(tolerance.unwrap_or_default()[place]) + slack;
                number.is_finite() && (number - f64::from(answer(*channel))).abs() <= allowed
            };
            if !channels.iter().zip(numbers).all(is_right) {
                wrong.push(*part);
            }
        }
        wrong
    }

    /// The mistakes whose answer to a question differs from the right one in what a claim is about.
    fn caught(&self, place: usize, claim: &Claim) -> impl Iterator<Item = &'a str> {
        let mut right = self.right_answer(place);
        let is_claimed = |part: &str| claim.parts.iter().any(|(own, _)| *own == part);
        right.parts.retain(|(part, _)| is_claimed(part));
        self.prints.iter().filter_map(move |(slug, print)| {
            let witness = print.sample.iter().find(|it| it.pixel == place)?;
            let answer = |channel: usize| witness.values[channel];
            let differs = !self.contradictions(place, &right, &answer).is_empty();
            differs.then_some(*slug)
        })
    }
}
