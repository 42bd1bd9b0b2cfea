//! The evidence for a mark, for the lecturer alone. It contains everything that was asked, expected
//! and answered, even for groups of which the student learns only that they fail.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use pinhole_course::error::{Result, ResultExt};
use pinhole_course::outcome::Outcome;
use pinhole_course::submission::Submission;

/// The folder with all evidence, in the folder of a graded class. Nothing in it is for students.
pub const FOLDER: &str = "evidence";

/// The evidence for one mark.
#[derive(Clone, Debug, Deserialize, Serialize)]
pub struct Evidence {
    /// The submission's id.
    pub id: String,
    /// The outcome of the public and withheld questions, as judged.
    pub public: Outcome,
    /// The outcome of the fresh questions, if they were asked.
    pub fresh: Option<Outcome>,
    /// The folder of the fresh questions.
    pub fresh_folder: Option<PathBuf>,
    /// The answers, by task.
    pub answers: BTreeMap<String, String>,
}

impl Evidence {
    /// Collects the evidence before anything is redacted.
    pub fn new(
        id: &str,
        submission: &Submission,
        public: &Outcome,
        fresh: Option<(&Outcome, &Path)>,
    ) -> Evidence {
        let answers = submission.answers.iter().filter_map(|answer| {
            let text = answer.text.as_ref().ok()?;
            Some((answer.task.clone(), text.clone()))
        });
        Evidence {
            id: id.into(),
            public: public.clone(),
            fresh: fresh.map(|(outcome, _)| outcome.clone()),
            fresh_folder: fresh.map(|(_, folder)| folder.into()),
            answers: answers.collect(),
        }
    }

    /// The evidence's file, in the folder of a graded class.
    pub fn file(id: &str) -> String {
        format!("{FOLDER}/{id}.json")
    }

    /// Reads the evidence for a submission from the folder of a graded class.
    pub fn read(out: &Path, id: &str) -> Result<Evidence> {
        let path = out.join(Evidence::file(id));
        let text = std::fs::read_to_string(&path).or_input(
            format_args!("cannot read {}", path.display()),
            "grade that submission again: this version of Pinhole keeps what `dispute` needs",
        )?;
        serde_json::from_str(&text).or_input(
            path.display(),
            "grade that submission again with this version of Pinhole",
        )
    }
}
