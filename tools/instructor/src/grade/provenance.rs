//! What a mark was made from: enough to know whether grading again could change it.

use std::fs;
use std::path::Path;
use std::process::Command;

use hmac_sha256::Hash;
use serde::{Deserialize, Serialize};

use super::redact::Reveal;
use pinhole_course::assignment::Assignment;
use pinhole_course::error::{Result, ResultExt};
use pinhole_course::submission::{Submission, Unusable};

/// Hashes and settings; equal ones give equal marks.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Provenance {
    /// The answers: task, and the hash of the file or why there is none.
    pub answers: Vec<(String, String)>,
    #[serde(flatten)]
    pub made_with: MadeWith,
}

/// What is the same for the whole class.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct MadeWith {
    /// "public goldens and fresh questions", say.
    pub judged_on: String,
    /// What the fresh questions were drawn from; not for students.
    pub seed: Option<u64>,
    /// The manifest of the goldens, which names every film's hash.
    pub goldens: String,
    /// That of the fresh ones.
    pub fresh: Option<String>,
    /// Tasks and points.
    pub assignment: String,
    pub tool: Tool,
    /// What walled the student's code off.
    pub sandbox: String,
    /// Seconds an answer may take.
    pub timeout: u64,
    /// How much of withheld questions is shown; none if there are none.
    pub reveal: Option<Reveal>,
}

/// The program that graded.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Tool {
    pub version: String,
    /// Of the executable.
    pub sha256: String,
    pub rustc: String,
}

impl Tool {
    /// This program.
    pub fn this() -> Result<Tool> {
        let own = std::env::current_exe().and_then(fs::read).or_environment(
            "cannot read this program's own file",
            "build it again: cargo build --release",
        )?;
        let rustc = Command::new("rustc").arg("--version").output();
        let rustc = rustc.map(|output| String::from_utf8_lossy(&output.stdout).trim().to_owned());
        Ok(Tool {
            version: env!("CARGO_PKG_VERSION").into(),
            sha256: sha256(&own),
            rustc: rustc.unwrap_or_default(),
        })
    }
}

impl Provenance {
    /// That of a submission.
    pub fn of(submission: &Submission, made_with: &MadeWith) -> Provenance {
        let answers = submission.answers.iter().map(|answer| {
            let state = match &answer.text {
                Ok(text) => sha256(text.as_bytes()),
                Err(Unusable::Missing) => "missing".into(),
                Err(Unusable::Refused(why)) => format!("refused: {why}"),
            };
            (answer.task.clone(), state)
        });
        Provenance {
            answers: answers.collect(),
            made_with: made_with.clone(),
        }
    }
}

/// The hash of a file's content.
pub fn of_file(path: &Path) -> Result<String> {
    let bytes = fs::read(path).or_input(
        format_args!("cannot read {}", path.display()),
        "name a folder of goldens with its manifest",
    )?;
    Ok(sha256(&bytes))
}

/// The hash of what an assignment asks.
pub fn of_assignment(assignment: &Assignment) -> Result<String> {
    of_file(&assignment.folder.join("assignment.toml"))
}

/// SHA-256 in hexadecimal.
pub fn sha256(bytes: &[u8]) -> String {
    hex::encode(Hash::hash(bytes))
}
