//! Which belief explains a wrong film.

pub mod evidence;
pub mod fingerprint;
pub mod known;
mod reason;

use crate::mistake::Mistake;

/// What is known of why something is wrong.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Diagnosis {
    /// Beliefs that explain what came. Empty if nothing known does: a false name is
    /// worse than none.
    pub beliefs: Vec<Explanation>,
    /// How several beliefs are meant.
    pub reading: Reading,
}

/// How the beliefs of a [`Diagnosis`] go together.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Reading {
    /// All of them are held, each spoiling its part.
    #[default]
    Together,
    /// One of them is held; what came cannot tell them apart.
    OneOf,
}

/// A belief and what it explains.
#[derive(Clone, Debug, PartialEq)]
pub struct Explanation {
    /// The known mistake's name.
    pub slug: String,
    /// What is believed, and the hints.
    pub mistake: Mistake,
    /// The share of the wrong pixels or questions that this belief predicts as they
    /// came, 0 to 1.
    pub explained: f64,
}

impl Diagnosis {
    fn of(beliefs: Vec<Explanation>, reading: Reading) -> Diagnosis {
        Diagnosis { beliefs, reading }
    }

    /// Whether nothing is named.
    pub fn is_empty(&self) -> bool {
        self.beliefs.is_empty()
    }
}

#[cfg(test)]
mod tests;
