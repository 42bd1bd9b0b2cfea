//! Lays answers over the reference's, which makes whole submissions of mistakes, variants and
//! mutants.

use std::fs;
use std::path::Path;

use crate::assignment::Assignment;
use crate::error::{Result, ResultExt};
use crate::submission::{Answer, Submission};

/// The reference answers as a submission.
pub fn reference(assignment: &Assignment) -> Result<Submission> {
    Submission::find(&assignment.reference(), assignment)
}

impl Submission {
    /// This submission with the answer files of `folder` in place of its own.
    pub fn overlaid(mut self, folder: &Path) -> Result<Submission> {
        for answer in &mut self.answers {
            let path = folder.join(&answer.task).with_extension("rs");
            if path.is_file() {
                let text = fs::read_to_string(&path).or_input(
                    format_args!("cannot read {}", path.display()),
                    "restore the file",
                )?;
                answer.text = Ok(text);
            }
        }
        self.folder = folder.into();
        self.place = folder.into();
        Ok(self)
    }

    /// This submission with another answer to one task.
    pub fn with_answer(mut self, task: &str, text: String) -> Submission {
        for Answer { text: old, .. } in self.answers.iter_mut().filter(|a| a.task == task) {
            *old = Ok(text.clone());
        }
        self
    }
}
