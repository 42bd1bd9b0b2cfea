//! Judges every mutant. Each must be caught by its own task's questions or by a scene, or be
//! listed as equivalent.

use std::collections::BTreeMap;
use std::fs;
use std::time::Duration;

use serde::Serialize;

use super::difference::{Difference, Oracle};
use super::equivalents::{self, EquivalentMutant, FILE};
use super::mutate::{self, Mutant};
use super::sentences::Sentences;
use super::validator::Validator;
use pinhole_course::compile::{Attempt, Program, Replacements};
use pinhole_course::error::{Result, ResultExt};
use pinhole_course::examine::Selection;
use pinhole_course::overlay;
use pinhole_course::submission::Submission;

/// The results of all mutants.
#[derive(Debug, Serialize)]
pub struct Mutants {
    /// One for each, in the order of tasks and lines.
    pub judged: Vec<MutantVerdict>,
    /// False entries in the list of equivalent mutants.
    pub faults: Vec<String>,
}

/// One mutant and its result.
#[derive(Debug, Serialize)]
pub struct MutantVerdict {
    /// The mutant.
    pub mutant: Mutant,
    /// Its result.
    pub fate: Fate,
    /// What was measured in its answers, if its own task's questions fail.
    pub sentences: Sentences,
}

/// The result of a mutant.
#[derive(Debug, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Fate {
    /// It does not compile.
    NotViable,
    /// These groups of its own task's questions fail.
    Probes(Vec<String>),
    /// Its own task's questions all pass, and this scene fails.
    Scene(String),
    /// Nothing fails.
    Escaped {
        /// Where its answers differ from the reference's.
        difference: Difference,
        /// Why it is not a mistake, if the list says so and the difference agrees.
        why: Option<String>,
    },
}

/// A mutant that takes longer than this for a task or a scene is in an endless loop. The
/// reference takes less than a second.
const WALL: Duration = Duration::from_secs(10);

/// A law must be found for at least this share of the mutants whose numbers are wrong.
const ENOUGH_TOLD: f64 = 0.9;

/// Judges the mutants of every answer whose names contain `named`.
pub fn judge(validator: &Validator, named: &str) -> Result<Mutants> {
    // Mutants need no diagnosis.
    let goldens = validator.goldens.without_known();
    let validator = &Validator {
        goldens: &goldens,
        ..*validator
    };
    let reference = overlay::reference(validator.assignment)?;
    let all = generate(&reference)?;
    let listed = equivalents::read(validator.assignment)?;
    let mut faults = equivalents::without_mutant(&listed, &all);
    let wanted = all
        .into_iter()
        .filter(|mutant| mutant.name().contains(named));
    let wanted: Vec<Mutant> = wanted.collect();

    let oracle = Oracle::new(validator, validator.compiler.compile(&reference)?);
    let judge = |mutant: &Mutant| {
        let (fate, sentences) = fate(validator, &reference, mutant, &oracle, &listed)?;
        let mutant = mutant.clone();
        Ok(MutantVerdict {
            mutant,
            fate,
            sentences,
        })
    };
    let judged = validator.all("mutants", &wanted, judge)?;
    faults.extend(judged.iter().filter_map(|judged| judged.fault(&listed)));
    Ok(Mutants { judged, faults })
}

/// All mutants of the reference.
pub fn generate(reference: &Submission) -> Result<Vec<Mutant>> {
    let mut all = Vec::new();
    for answer in &reference.answers {
        let text = answer.text.as_deref().unwrap_or_default();
        let mutants = mutate::mutants(&answer.task, text).or_environment(
            format_args!("the reference's {}.rs is not Rust", answer.task),
            "restore the assignment's `reference` folder",
        )?;
        all.extend(mutants);
    }
    Ok(all)
}

fn fate(
    validator: &Validator,
    reference: &Submission,
    mutant: &Mutant,
    oracle: &Oracle,
    listed: &[EquivalentMutant],
) -> Result<(Fate, Sentences)> {
    let submission = reference
        .clone()
        .with_answer(&mutant.task, mutant.text.clone());
    let is_not_viable = &mut |replaced: &Replacements| replaced.contains_key(&mutant.task);
    let Attempt::Program(program) = validator
        .compiler
        .compile_until(&submission, is_not_viable)?
    else {
        return Ok((Fate::NotViable, Sentences::default()));
    };
    let fate = fate_of_program(validator, &submission, &program, mutant, oracle, listed);
    let sentences = match (&fate, validator.assignment.task(&mutant.task)) {
        (Ok(Fate::Probes(_)), Some(task)) => {
            Sentences::of(validator, &program, task, &mutant.name())
        }
        _ => Ok(Sentences::default()),
    };
    discard(&program);
    Ok((fate?, sentences?))
}

fn fate_of_program(
    validator: &Validator,
    submission: &Submission,
    program: &Program,
    mutant: &Mutant,
    oracle: &Oracle,
    listed: &[EquivalentMutant],
) -> Result<Fate> {
    let ask =
        |selection: Selection| validator.examine_built(program, submission, &selection, WALL, None);
    // Ask the task alone, because no other task's questions can show the mutant.
    let alone = ask(Selection {
        tasks: vec![mutant.task.clone()],
        scenes: Vec::new(),
    })?;
    let groups = alone.outcome.tasks.iter().flat_map(|task| &task.groups);
    let failing = groups.filter(|group| !group.outcome.passes());
    let failing: Vec<String> = failing
        .map(|group| format!("{}.{}", mutant.task, group.name))
        .collect();
    if !failing.is_empty() {
        return Ok(Fate::Probes(failing));
    }
    for scene in &validator.goldens.scenes {
        let examined = ask(Selection {
            tasks: Vec::new(),
            scenes: vec![scene.name.clone()],
        })?;
        if !examined.outcome.passes {
            return Ok(Fate::Scene(scene.name.clone()));
        }
    }
    let task = validator.assignment.task(&mutant.task);
    let task = task.expect("a mutant is of one of the assignment's tasks");
    let difference = oracle.compare(task, program)?;
    let listed = listed.iter().find(|listed| listed.is(mutant));
    let why = listed.filter(|listed| listed.claim.agrees(&difference));
    Ok(Fate::Escaped {
        why: why.map(|listed| listed.why.clone()),
        difference,
    })
}

impl MutantVerdict {
    /// Whether it compiles.
    pub fn is_viable(&self) -> bool {
        !matches!(self.fate, Fate::NotViable)
    }

    /// The groups of its own task's questions that catch it, if any do.
    pub fn groups(&self) -> Option<&[String]> {
        match &self.fate {
            Fate::Probes(groups) => Some(groups),
            _ => None,
        }
    }

    /// Whether it is rightly listed as equivalent.
    pub fn is_equivalent(&self) -> bool {
        matches!(self.fate, Fate::Escaped { why: Some(_), .. })
    }

    /// Whether it is a mistake that no question and no scene catches.
    pub fn is_missed(&self) -> bool {
        matches!(self.fate, Fate::Escaped { why: None, .. })
    }

    fn fault(&self, listed: &[EquivalentMutant]) -> Option<String> {
        let name = self.mutant.name();
        let diff = self.mutant.diff();
        let is_listed = listed.iter().any(|listed| listed.is(&self.mutant));
        match &self.fate {
            Fate::NotViable if is_listed => Some(format!(
                "listed in {FILE}, but does not compile: {name}\n{diff}"
            )),
            Fate::Probes(by) if is_listed => Some(format!(
                "listed in {FILE}, but caught by {}: {name}\n{diff}",
                by.join(", ")
            )),
            Fate::Scene(by) if is_listed => Some(format!(
                "listed in {FILE}, but caught by {by}: {name}\n{diff}"
            )),
            Fate::Escaped {
                why: None,
                difference,
            } => {
                let word = match is_listed {
                    true => format!("listed in {FILE}, which claims other differences"),
                    false => "missed".into(),
                };
                Some(format!("{word}: {name}\n{diff}\n  {difference}"))
            }
            _ => None,
        }
    }
}

impl Mutants {
    /// The targets that were missed.
    pub fn faults(&self) -> Vec<String> {
        let sentences = self.sentences().faults("mutants", ENOUGH_TOLD);
        self.faults.iter().cloned().chain(sentences).collect()
    }

    /// What was measured of all mutants.
    pub fn sentences(&self) -> Sentences {
        Sentences::sum(self.judged.iter().map(|judged| &judged.sentences))
    }

    /// How many mutants satisfy a condition.
    pub fn count(&self, predicate: impl Fn(&MutantVerdict) -> bool) -> usize {
        self.judged
            .iter()
            .filter(|judged| predicate(judged))
            .count()
    }

    /// How many mutants fail in each group of questions, and how many of them in no
    /// other group.
    pub fn by_group(&self) -> BTreeMap<&str, (usize, usize)> {
        let mut counts = BTreeMap::new();
        for groups in self.judged.iter().filter_map(MutantVerdict::groups) {
            for group in groups {
                let (all, only) = counts.entry(group.as_str()).or_insert((0, 0));
                *all += 1;
                *only += usize::from(groups.len() == 1);
            }
        }
        counts
    }
}

/// Deletes a program, because hundreds of mutants are not worth keeping.
fn discard(program: &Program) {
    if let Some(folder) = program.executable.parent() {
        let _ = fs::remove_dir_all(folder); // another run may have deleted it
    }
}
