//! Two beliefs inside one answer: the reference with the edits of both.
//!
//! The edits are data of the assignment. Any two beliefs whose edits change different places make
//! a pair.

use std::fs;
use std::ops::Range;

use serde::{Deserialize, Serialize};

use super::naming::NameCounts;
use super::sentences::{FEW, Sentences};
use super::validator::{Base, Validator};
use pinhole_course::diagnosis::Diagnosis;
use pinhole_course::error::{Error, Result, ResultExt};
use pinhole_course::examine::Selection;
use pinhole_course::overlay;
use pinhole_course::submission::Submission;

/// The file's name in an assignment.
const FILE: &str = "pairs.toml";

/// How many pairs are judged for each task without `--pairs`.
const SAMPLE: usize = 5;

/// The share of pairs for which at least one belief must be named.
const ENOUGH: f64 = 0.8;

/// A law must be found for at least this share of the pairs.
const ENOUGH_TOLD: f64 = 0.95;

/// Beliefs that give the same answers explain at least this share of what is wrong.
const ALL: f64 = 0.99;

/// A belief as edits of the reference.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Belief {
    task: String,
    mistake: String,
    /// A text that the reference has once, and its replacement.
    edits: Vec<[String; 2]>,
}

/// A pair that gives the same answers as other beliefs, so that their names are right, too.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct SamePair {
    beliefs: [String; 2],
    same_as: Vec<String>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    #[serde(default)]
    belief: Vec<Belief>,
    #[serde(default)]
    pair: Vec<SamePair>,
}

/// The results of the pairs.
#[derive(Debug, Serialize)]
pub struct Pairs {
    /// How many there are in the assignment.
    pub all: usize,
    /// Names of one belief or of both.
    pub names: NameCounts,
    /// How many had both beliefs named.
    pub both: usize,
    /// Pairs that got no name or a wrong one.
    pub unnamed: Vec<String>,
    /// Pairs that pass everything, because each belief hides the other.
    pub passing: Vec<String>,
    /// What was measured in their answers.
    pub sentences: Sentences,
}

/// Two beliefs in one answer.
struct Pair {
    task: String,
    beliefs: [String; 2],
    /// Beliefs that together give the same answers. Usually none are known.
    same_as: Vec<String>,
    text: String,
}

/// Judges pairs whose names contain `named`: a few for each task, or all.
pub fn judge(validator: &Validator, named: &str, all: bool) -> Result<Option<Pairs>> {
    let path = validator.assignment.folder.join(FILE);
    let Ok(text) = fs::read_to_string(&path) else {
        return Ok(None);
    };
    let File { belief, pair } =
        toml::from_str(&text).or_input(path.display(), "correct the file")?;
    let reference = overlay::reference(validator.assignment)?;
    let mut pairs = pairs(&belief, &reference)?;
    for SamePair { beliefs, same_as } in pair {
        let listed = pairs.iter_mut().find(|pair| pair.beliefs == beliefs);
        let listed = listed.ok_or_else(|| {
            Error::input(
                format!("{FILE}: {} are not a pair", beliefs.join(" and ")),
                "name two beliefs in the file's order whose edits change different places",
            )
        })?;
        listed.same_as = same_as;
    }
    let count = pairs.len();
    let mut wanted = Vec::new();
    for task in &validator.assignment.tasks {
        let own = pairs.iter().filter(|pair| pair.task == task.name);
        let own: Vec<&Pair> = own.filter(|pair| pair.name().contains(named)).collect();
        let step = match all {
            true => 1,
            false => own.len().div_ceil(SAMPLE).max(1),
        };
        wanted.extend(own.into_iter().step_by(step));
    }
    let base = Base::new(reference.clone());
    let judged = validator.all("pairs", &wanted, |pair| pair.judge(validator, &base))?;
    let mut names = NameCounts::default();
    let mut pairs = Pairs {
        all: count,
        names: NameCounts::default(),
        both: 0,
        unnamed: Vec::new(),
        passing: Vec::new(),
        sentences: Sentences::sum(judged.iter().map(|judged| &judged.sentences)),
    };
    for judged in &judged {
        names.add(&judged.names);
        pairs.both += usize::from(judged.both);
        match judged.fails {
            false => pairs.passing.push(judged.name.clone()),
            true if judged.names.right + judged.names.among == 0 => {
                pairs.unnamed.push(judged.name.clone());
            }
            true => {}
        }
    }
    Ok(Some(Pairs { names, ..pairs }))
}

/// The result of one pair.
struct PairResult {
    name: String,
    fails: bool,
    names: NameCounts,
    both: bool,
    sentences: Sentences,
}

impl Pair {
    fn name(&self) -> String {
        self.beliefs.join(" + ")
    }

    /// The beliefs whose names are right: those of the pair, unless the diagnosis names all beliefs that
    /// give the same answers, and these explain nearly everything.
    fn right(&self, diagnosis: &Diagnosis) -> &[String] {
        let named = &diagnosis.beliefs;
        let explained: f64 = named.iter().map(|belief| belief.explained).sum();
        let is_named = |slug: &String| named.iter().any(|belief| belief.slug == *slug);
        let is_same = !self.same_as.is_empty()
            && self.same_as.len() == named.len()
            && self.same_as.iter().all(is_named);
        match is_same && explained >= ALL {
            true => &self.same_as,
            false => &self.beliefs,
        }
    }

    fn judge(&self, validator: &Validator, base: &Base) -> Result<PairResult> {
        let submission = base.submission.clone();
        let submission = submission.with_answer(&self.task, self.text.clone());
        let program = validator.compiler.compile(&submission)?;
        if program.replaced.contains_key(&self.task) {
            return Err(Error::input(
                format!("{}: it does not compile", self.name()),
                format!("correct the edits in {FILE}"),
            ));
        }
        let selection = Selection {
            tasks: vec![self.task.clone()],
            scenes: Vec::new(),
        };
        let wall = super::validator::WALL;
        let examined = validator.examine_built(&program, &submission, &selection, wall, None)?;
        let outcome = examined.outcome.tasks.first();
        let failing = outcome.filter(|task| !task.passes());
        let mut names = NameCounts::default();
        let mut both = false;
        let mut sentences = Sentences::default();
        if let Some(outcome) = failing {
            names.count(
                &self.name(),
                &outcome.diagnosis,
                self.right(&outcome.diagnosis),
            );
            let named = |belief: &String| {
                let mut named = outcome.diagnosis.beliefs.iter();
                named.any(|held| held.slug == *belief)
            };
            both = self.beliefs.iter().all(named);
            let task = validator.assignment.task(&self.task);
            let task = task.expect("the pair's answer is one of the reference's");
            sentences = Sentences::of(validator, &program, task, &self.name())?;
        }
        Ok(PairResult {
            name: self.name(),
            fails: failing.is_some(),
            names,
            both,
            sentences,
        })
    }
}

/// All pairs of beliefs about one task whose edits change different places.
fn pairs(beliefs: &[Belief], reference: &Submission) -> Result<Vec<Pair>> {
    let mut pairs = Vec::new();
    for (k, one) in beliefs.iter().enumerate() {
        let text = text_of(reference, &one.task)?;
        let places = one.places(text)?;
        for other in beliefs[k + 1..].iter().filter(|it| it.task == one.task) {
            let mut both: Vec<(Range<usize>, &str)> = places.clone();
            both.extend(other.places(text)?);
            both.sort_by_key(|(place, _)| place.start);
            if both.windows(2).any(|two| two[0].0.end > two[1].0.start) {
                continue;
            }
            let mut edited = text.to_owned();
            for (place, becomes) in both.iter().rev() {
                edited.replace_range(place.clone(), becomes);
            }
            pairs.push(Pair {
                task: one.task.clone(),
                beliefs: [one.mistake.clone(), other.mistake.clone()],
                same_as: Vec::new(),
                text: edited,
            });
        }
    }
    Ok(pairs)
}

fn text_of<'a>(reference: &'a Submission, task: &str) -> Result<&'a str> {
    let mut answers = reference.answers.iter();
    let answer = answers.find(|answer| answer.task == task);
    let text = answer.and_then(|answer| answer.text.as_deref().ok());
    text.ok_or_else(|| Error::input(format!("{FILE}: there is no task `{task}`"), "correct it"))
}

impl Belief {
    /// The places of its edits, and their replacements.
    fn places(&self, text: &str) -> Result<Vec<(Range<usize>, &str)>> {
        let place = |was: &String| -> Result<Range<usize>> {
            let mut found = text.match_indices(was.as_str());
            match (found.next(), found.next()) {
                (Some((start, _)), None) => Ok(start..start + was.len()),
                _ => Err(Error::input(
                    format!("{FILE}: the reference does not contain this exactly once: {was}"),
                    "choose a text that occurs once in the reference",
                )),
            }
        };
        let edits = self.edits.iter();
        edits
            .map(|edit| Ok((place(&edit[0])?, edit[1].as_str())))
            .collect()
    }
}

impl Pairs {
    /// The targets that were missed.
    pub fn faults(&self) -> Vec<String> {
        let wrong = self.names.wrong.iter();
        let mut faults: Vec<String> = wrong.map(|film| format!("false name: {film}")).collect();
        let (judged, named) = (self.names.all(), self.names.right + self.names.among);
        if judged >= FEW && (named as f64) < ENOUGH * judged as f64 {
            faults.push(format!(
                "only {named} of {judged} pairs of beliefs get a right name"
            ));
        }
        faults.extend(self.sentences.faults("pairs", ENOUGH_TOLD));
        faults
    }
}
