//! Finds the mistaken belief that explains a wrong film.

pub mod evidence;
pub mod fingerprint;
pub mod known;
pub mod measure;
pub mod parts;
pub mod pixels;
mod reason;

use serde::{Deserialize, Serialize};

use crate::mistake::Mistake;

/// The known beliefs that explain why something is wrong.
#[derive(Clone, Debug, Default, Deserialize, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Diagnosis {
    /// Beliefs that explain the answers. Empty if no known belief does, because a false name is
    /// worse than none.
    pub beliefs: Vec<Explanation>,
    /// How several beliefs belong together.
    pub reading: Reading,
}

/// How the beliefs of a [`Diagnosis`] belong together.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(rename_all = "lowercase")]
pub enum Reading {
    /// The student holds all of them, and each spoils a part of the answers.
    #[default]
    Together,
    /// The student holds one of them; the answers don't tell which.
    #[serde(rename = "one of")]
    OneOf,
}

/// A belief and what it explains.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Explanation {
    /// The known mistake's name.
    #[serde(rename = "mistake")]
    pub slug: String,
    /// The belief, and hints for a student who holds it.
    #[serde(flatten)]
    pub mistake: Mistake,
    /// The share of the wrong pixels or questions for which this belief predicts the given
    /// values, 0 to 1.
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

/// In documents, a diagnosis that names nothing is null.
pub mod or_null {
    use serde::{Deserialize, Deserializer, Serialize, Serializer};

    use super::Diagnosis;

    /// Writes the diagnosis, or null.
    pub fn serialize<S: Serializer>(
        diagnosis: &Diagnosis,
        serializer: S,
    ) -> Result<S::Ok, S::Error> {
        let named = (!diagnosis.is_empty()).then_some(diagnosis);
        named.serialize(serializer)
    }

    /// Reads either.
    pub fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Diagnosis, D::Error> {
        let named = Option::deserialize(deserializer)?;
        Ok(named.unwrap_or_default())
    }
}

#[cfg(test)]
mod tests;
