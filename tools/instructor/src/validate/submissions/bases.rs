//! The answers that mistakes, rewrites and variants are laid over.

use std::fs;
use std::path::PathBuf;

use crate::validate::validator::{Base, Validator};
use pinhole_course::error::{Result, ResultExt};
use pinhole_course::mistake;
use pinhole_course::overlay;
use pinhole_course::submission::Submission;

/// Whose answers lie under an overlay.
#[derive(Clone, Copy)]
pub enum Under {
    /// The reference's.
    Reference,
    /// The reference's, and its belief is diagnosed as if nobody had met it before: its
    /// own films are those that are stored.
    ReferenceUnaware,
    /// A mixture of variants, each task's by another route; the number turns them over. So
    /// the program has nothing in common with the films' but the belief.
    Variants(usize),
}

/// The number of mixtures of variants. More would only repeat the same questions.
const MIXTURES: usize = 8;

/// What lies under overlays, with the replies that they have in common.
pub struct Bases {
    reference: Base,
    mixtures: Vec<Base>,
}

impl Bases {
    /// Reads the reference and the variants.
    pub fn new(validator: &Validator) -> Result<Bases> {
        let reference = overlay::reference(validator.assignment)?;
        let mixed = |turn| variants_mixed(validator, reference.clone(), turn).map(Base::new);
        Ok(Bases {
            mixtures: (0..MIXTURES).map(mixed).collect::<Result<_>>()?,
            reference: Base::new(reference),
        })
    }

    /// What lies under an overlay.
    pub fn of(&self, under: Under) -> &Base {
        match under {
            Under::Reference | Under::ReferenceUnaware => &self.reference,
            Under::Variants(turn) => &self.mixtures[turn % MIXTURES],
        }
    }
}

/// Every task's answer by some variant's route, if there is one.
fn variants_mixed(validator: &Validator, base: Submission, turn: usize) -> Result<Submission> {
    let variants = mistake::folders(&validator.assignment.folder.join("variants"));
    let mut mixed = base;
    for task in &validator.assignment.tasks {
        let mut files = variants.iter().map(|(_, folder)| folder.join(task.file()));
        let files: Vec<PathBuf> = files.by_ref().filter(|file| file.is_file()).collect();
        let Some(file) = files.get(turn % files.len().max(1)) else {
            continue;
        };
        let text = fs::read_to_string(file).or_input(
            format_args!("cannot read {}", file.display()),
            "restore the file",
        )?;
        mixed = mixed.with_answer(&task.name, text);
    }
    Ok(mixed)
}
