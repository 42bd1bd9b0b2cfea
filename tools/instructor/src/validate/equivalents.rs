//! Mutants that are known not to be mistakes. Each entry says where the mutant differs from the
//! reference, and why it differs nowhere else.
//! The list proves nothing. Whenever the mutants are judged, we search for a difference that
//! refutes an entry.

use std::fs;

use serde::Deserialize;

use super::difference::Difference;
use super::mutate::Mutant;
use pinhole_course::assignment::Assignment;
use pinhole_course::error::{Error, Result, ResultExt};

/// The file's name in an assignment.
pub const FILE: &str = "equivalent.toml";

/// One entry.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct EquivalentMutant {
    /// The task whose answer it changes.
    pub task: String,
    /// The changed line as the reference has it, without indentation.
    pub was: String,
    /// The changed line as the mutant has it, without indentation.
    pub becomes: String,
    /// Where it differs from the reference.
    #[serde(rename = "differs")]
    pub claim: Claim,
    /// Why it does not differ anywhere else.
    pub why: String,
}

/// Where a mutant differs from the reference.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq)]
#[serde(rename_all = "lowercase")]
pub enum Claim {
    /// On no question.
    Nowhere,
    /// Only where exact arithmetic says that a question is a tie.
    Ties,
    /// On other questions too, but every answer is one of several right ones.
    Allowed,
}

impl Claim {
    /// Whether the search found what the entry claims.
    pub fn agrees(self, found: &Difference) -> bool {
        match self {
            Claim::Nowhere => found.elsewhere == 0 && found.on_ties == 0,
            Claim::Ties => found.elsewhere == 0 && found.on_ties > 0,
            Claim::Allowed => found.elsewhere > 0,
        }
    }
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    #[serde(default)]
    mutant: Vec<EquivalentMutant>,
}

impl EquivalentMutant {
    /// Whether this entry is about `mutant`.
    pub fn is(&self, mutant: &Mutant) -> bool {
        self.task == mutant.task && self.was == mutant.was && self.becomes == mutant.becomes
    }
}

/// The list of an assignment; empty if it has none.
pub fn read(assignment: &Assignment) -> Result<Vec<EquivalentMutant>> {
    let path = assignment.folder.join(FILE);
    if !path.is_file() {
        return Ok(Vec::new());
    }
    let wrong = Error::input(
        path.display().to_string(),
        "correct the file; its first lines say how",
    );
    let text = fs::read_to_string(&path).or_fail(&wrong)?;
    let file: File = toml::from_str(&text).or_fail(&wrong)?;
    Ok(file.mutant)
}

/// Entries about mutants that are not generated any more.
pub fn without_mutant(listed: &[EquivalentMutant], mutants: &[Mutant]) -> Vec<String> {
    let gone = listed
        .iter()
        .filter(|listed| !mutants.iter().any(|mutant| listed.is(mutant)));
    gone.map(|listed| {
        let EquivalentMutant { task, becomes, .. } = listed;
        format!("listed in {FILE}, but no longer a mutant of {task}: {becomes}")
    })
    .collect()
}
