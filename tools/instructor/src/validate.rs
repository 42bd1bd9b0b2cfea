//! Tests the grading: judges submissions whose verdict is known, and compares the verdicts.
//!
//! Reading order: [`validator`] judges one submission. [`submissions`] judges those that people
//! wrote, and [`mutants`] those that a program writes ([`mutate`]); [`equivalents`] lists mutants
//! that are not mistakes, and [`difference`] tests that list by searching for differences.
//! [`hints`] checks the wording of hints, [`catches`] counts which questions catch which
//! mistakes, [`sensitivity`] measures how small an error the scenes still detect, and `table`
//! shows the results.

mod catches;
mod difference;
mod draws;
mod equivalents;
pub mod hints;
mod mutants;
mod mutate;
mod naming;
mod pairs;
mod sensitivity;
mod sentences;
mod submissions;
mod table;
mod ties;
pub mod validator;

use std::path::PathBuf;

use clap::ValueEnum;
use serde::Serialize;

use catches::DetectionTable;
use draws::Draws;
use mutants::Mutants;
use naming::{Diagnoses, NameCounts};
use pairs::Pairs;
use pinhole_course::error::Result;
use pinhole_course::mistake;
use sensitivity::Sensitivity;
use submissions::{PristineVerdicts, SubmissionVerdicts};
use validator::Validator;

pub use table::validation as table;

/// What to validate.
#[derive(Clone, Debug)]
pub struct Plan {
    /// The parts to judge, in any order. The stub and the reference are always judged.
    pub parts: Vec<Part>,
    /// Whether to judge all pairs of beliefs, and not only a few for each task.
    pub all_pairs: bool,
    /// Folders of fresh questions, if draws are compared.
    pub draws: Option<PathBuf>,
    /// Judge only submissions whose name contains this text.
    pub named: String,
}

/// A part of the validation.
#[derive(Clone, Copy, Debug, PartialEq, ValueEnum)]
pub enum Part {
    /// Known mistakes and their rewrites: each must fail in the tasks that it declares
    Mistakes,
    /// Right answers that work differently: each must pass
    Variants,
    /// Two mistakes in one answer: the diagnosis should name one or both, and never a third
    Pairs,
    /// Copies of the reference with one small fault each: all must be caught
    Mutants,
    /// How small an error each scene still detects
    Sensitivity,
}

/// The result of a validation.
#[derive(Debug, Serialize)]
pub struct Validation {
    /// The assignment's title.
    pub assignment: String,
    /// The targets that were missed. Empty if all is well.
    pub faults: Vec<String>,
    /// The stub and the reference.
    pub pristine: PristineVerdicts,
    /// The known mistakes, if they were judged.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mistakes: Option<SubmissionVerdicts>,
    /// Rewrites of the known mistakes, if they were judged.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rewrites: Option<SubmissionVerdicts>,
    /// The variants, if they were judged.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub variants: Option<SubmissionVerdicts>,
    /// Pairs of beliefs, if they were judged.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub pairs: Option<Pairs>,
    /// The mutants, if they were judged.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mutants: Option<Mutants>,
    /// How often diagnoses give the right name, if mistakes were judged.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub diagnoses: Option<Diagnoses>,
    /// How much each group of questions and each scene catches.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub catches: Option<DetectionTable>,
    /// The smallest errors that the scenes detect, if they were measured.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sensitivity: Option<Vec<Sensitivity>>,
    /// Whether marks depend on the draw, if draws were compared.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub draws: Option<Draws>,
    /// How long it took.
    pub seconds: f64,
}

impl Validation {
    /// Whether only the stub and the reference were judged.
    pub fn is_empty(&self) -> bool {
        let known = [&self.mistakes, &self.rewrites, &self.variants];
        let judged = known
            .into_iter()
            .flatten()
            .any(|known| !known.judged.is_empty());
        let mutants = self
            .mutants
            .as_ref()
            .is_some_and(|mutants| !mutants.judged.is_empty());
        let scenes = self
            .sensitivity
            .as_ref()
            .is_some_and(|scenes| !scenes.is_empty());
        let pairs = self.pairs.as_ref().is_some_and(|pairs| {
            let NameCounts {
                right,
                among,
                none,
                wrong,
            } = &pairs.names;
            right + among + none + wrong.len() + pairs.passing.len() > 0
        });
        !(judged || mutants || scenes || pairs || self.draws.is_some())
    }
}

/// Runs the planned parts.
///
/// # Errors
/// If something cannot be judged at all; a wrong verdict is in the result.
pub fn validate(validator: &Validator, plan: &Plan) -> Result<Validation> {
    let start = std::time::Instant::now();
    let wants = |part| plan.parts.contains(&part);
    let pristine = submissions::pristine(validator)?;
    let (mistakes, rewrites) = match wants(Part::Mistakes) {
        true => {
            let (mistakes, rewrites) = submissions::mistakes(validator, &plan.named)?;
            (Some(mistakes), Some(rewrites))
        }
        false => (None, None),
    };
    let variants = match wants(Part::Variants) {
        true => Some(submissions::variants(validator, &plan.named)?),
        false => None,
    };
    let pairs = match wants(Part::Pairs) {
        true => pairs::judge(validator, &plan.named, plan.all_pairs)?,
        false => None,
    };
    let mutants = match wants(Part::Mutants) {
        true => Some(mutants::judge(validator, &plan.named)?),
        false => None,
    };
    let sensitivity = match wants(Part::Sensitivity) {
        true => Some(sensitivity::measure(validator, &plan.named)?),
        false => None,
    };
    let draws = plan.draws.as_ref();
    let draws = draws.map(|folder| draws::judge_all(validator, folder, &plan.named));
    let draws = draws.transpose()?;
    let catches = (mistakes.is_some() || mutants.is_some()).then(|| {
        let judged = mistakes.as_ref().map_or(&[][..], |known| &known.judged);
        DetectionTable::count(validator, judged, mutants.as_ref())
    });

    let diagnoses = match (&mistakes, &rewrites) {
        (Some(mistakes), Some(rewrites)) => Some(Diagnoses::of(mistakes, rewrites)),
        _ => None,
    };

    let mut faults = pristine.faults.clone();
    faults.extend(diagnoses.iter().flat_map(Diagnoses::faults));
    faults.extend(hints::faults(&mistake::read_all(validator.assignment)?));
    for known in [&mistakes, &rewrites, &variants].into_iter().flatten() {
        faults.extend(known.judged.iter().flat_map(|judged| judged.faults()));
    }
    faults.extend(pairs.iter().flat_map(Pairs::faults));
    faults.extend(draws.iter().flat_map(Draws::faults));
    faults.extend(mutants.iter().flat_map(Mutants::faults));
    Ok(Validation {
        assignment: validator.assignment.title.clone(),
        faults,
        pristine,
        mistakes,
        rewrites,
        variants,
        pairs,
        mutants,
        diagnoses,
        catches,
        sensitivity,
        draws,
        seconds: start.elapsed().as_secs_f64(),
    })
}
