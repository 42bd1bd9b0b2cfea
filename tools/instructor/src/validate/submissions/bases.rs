//! The answers that mistakes, rewrites and variants are laid over.

use std::fs;
use std::path::PathBuf;

use crate::validate::validator::{Base, Validator};
use pinhole_course::error::{Result, ResultExt};
use pinhole_course::mistake;
use pinhole_course::overlay;
use pinhole_course::submission::Submission;

/// The answers that an overlay is laid over.
#[derive(Clone, Copy)]
pub enum OverlayBase {
    /// The reference's.
    Reference,
    /// The reference's. The overlay's belief is treated as unknown, because its stored films were
    /// made with this very overlay.
    ReferenceUnaware,
    /// A mixture of variants, with a different one for each task; the number selects the mixture.
    /// The program then shares nothing but the belief with the program whose films are stored.
    Variants(usize),
}

/// How many mixtures of variants there are. More would only repeat the same questions.
const MIXTURES: usize = 8;

/// The answers under overlays, with the replies that submissions share.
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

    /// The answers under an overlay.
    pub fn of(&self, under: OverlayBase) -> &Base {
        match under {
            OverlayBase::Reference | OverlayBase::ReferenceUnaware => &self.reference,
            OverlayBase::Variants(turn) => &self.mixtures[turn % MIXTURES],
        }
    }
}

/// For each task, the answer of a variant, if there is one.
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
