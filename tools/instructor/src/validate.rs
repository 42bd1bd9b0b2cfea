//! Grades the grading: judges submissions whose verdict is known beforehand, and compares the
//! verdicts with what is known.
//!
//! Reading order: [`validator`] judges one submission; [`submissions`] holds those that
//! people wrote, and [`mutants`] those that a program writes ([`mutate`]), with
//! [`equivalents`] for the ones that are not mistakes, which [`difference`] searches for
//! differences; [`catches`] counts which questions catch which mistakes; [`sensitivity`]
//! says how small an error the scenes still detect; [`table`] shows the results.

mod catches;
mod difference;
mod equivalents;
mod mutants;
mod mutate;
mod naming;
mod sensitivity;
mod submissions;
mod table;
mod ties;
pub mod validator;

use clap::ValueEnum;
use serde::Serialize;

use catches::Catches;
use mutants::Mutants;
use naming::Diagnoses;
use pinhole_course::error::Result;
use sensitivity::Sensitivity;
use submissions::{Pristine, SubmissionVerdicts};
use validator::Validator;

pub use table::validation as table;

/// What to validate.
#[derive(Clone, Debug)]
pub struct Plan {
    /// Which parts, in no order. The stub and the reference are always judged.
    pub parts: Vec<Part>,
    /// Only submissions whose name contains this.
    pub named: String,
}

/// A part of the validation.
#[derive(Clone, Copy, Debug, PartialEq, ValueEnum)]
pub enum Part {
    /// Known mistakes and rewrites of them: each must fail in its own tasks
    Mistakes,
    /// Right answers that work differently: each must pass
    Variants,
    /// Copies of the reference with one small fault each: all must be caught
    Mutants,
    /// How small an error each scene still detects
    Sensitivity,
}

/// What came of it.
#[derive(Debug, Serialize)]
pub struct Validation {
    /// The assignment's title.
    pub assignment: String,
    /// What misses a target; empty if all is well.
    pub faults: Vec<String>,
    /// The stub and the reference.
    pub pristine: Pristine,
    /// The known mistakes, if they were judged.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mistakes: Option<SubmissionVerdicts>,
    /// Rewrites of the known mistakes, if they were judged.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rewrites: Option<SubmissionVerdicts>,
    /// The variants, if they were judged.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub variants: Option<SubmissionVerdicts>,
    /// The mutants, if they were judged.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mutants: Option<Mutants>,
    /// How often diagnoses give the right name, if mistakes were judged.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub diagnoses: Option<Diagnoses>,
    /// How much each group of questions and each scene catches.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub catches: Option<Catches>,
    /// The smallest errors that the scenes detect, if they were measured.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sensitivity: Option<Vec<Sensitivity>>,
    /// How long it took.
    pub seconds: f64,
}

/// Does what is planned.
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
    let mutants = match wants(Part::Mutants) {
        true => Some(mutants::judge(validator, &plan.named)?),
        false => None,
    };
    let sensitivity = match wants(Part::Sensitivity) {
        true => Some(sensitivity::measure(validator, &plan.named)?),
        false => None,
    };
    let catches = (mistakes.is_some() || mutants.is_some()).then(|| {
        let judged = mistakes.as_ref().map_or(&[][..], |known| &known.judged);
        Catches::count(validator, judged, mutants.as_ref())
    });

    let diagnoses = match (&mistakes, &rewrites) {
        (Some(mistakes), Some(rewrites)) => Some(Diagnoses::of(mistakes, rewrites)),
        _ => None,
    };

    let mut faults = pristine.faults.clone();
    faults.extend(diagnoses.iter().flat_map(Diagnoses::faults));
    for known in [&mistakes, &rewrites, &variants].into_iter().flatten() {
        faults.extend(known.judged.iter().flat_map(|judged| judged.faults()));
    }
    faults.extend(mutants.iter().flat_map(|mutants| mutants.faults.clone()));
    Ok(Validation {
        assignment: validator.assignment.title.clone(),
        faults,
        pristine,
        mistakes,
        rewrites,
        variants,
        mutants,
        diagnoses,
        catches,
        sensitivity,
        seconds: start.elapsed().as_secs_f64(),
    })
}
