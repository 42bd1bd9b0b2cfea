//! Judges the answer to a task of an earlier assignment, with which scenes may be cast.

use super::Examiner;
use crate::assignment::EarlierAnswer;
use crate::compile::{Program, Replacement, WithOurs};
use crate::error::Result;
use crate::goldens::Goldens;
use crate::outcome::EarlierOutcome;
use crate::submission::AnswerFileProblem;

impl Examiner<'_> {
    /// The program that casts scenes, and what became of the answer of an earlier assignment. If
    /// that answer is wrong, scenes are cast with ours, unless other answers don't compile with ours.
    pub(super) fn judge_earlier(&self) -> Result<(Program, Option<EarlierOutcome>)> {
        let mut program = self.program.clone();
        let Some(earlier) = &self.assignment.earlier else {
            return Ok((program, None));
        };
        let problem = match program.replaced.get(&earlier.task.name) {
            None if program.with_ours == WithOurs::Same => return Ok((program, None)),
            None => self.failing_group(earlier)?,
            Some(Replacement::DoesNotCompile(_)) => Some("it does not compile here".into()),
            Some(Replacement::Unusable(AnswerFileProblem::Missing)) => return Ok((program, None)),
            Some(Replacement::Unusable(AnswerFileProblem::Refused(why))) => Some(why.clone()),
        };
        if let WithOurs::Executable(ours) = &program.with_ours
            && problem.is_some()
        {
            program.executable = ours.clone();
        }
        let outcome = EarlierOutcome {
            task: earlier.task.name.clone(),
            assignment: earlier.assignment.clone(),
            is_needed: program.with_ours == WithOurs::DoesNotCompile,
            problem,
        };
        Ok((program, Some(outcome)))
    }

    fn failing_group(&self, earlier: &EarlierAnswer) -> Result<Option<String>> {
        let questions = Goldens::of_earlier(self.assignment.course(), earlier)?;
        for (group, replies) in self.ask_task(&earlier.task, &questions, false)? {
            for (film, reply) in group.films.iter().zip(&replies) {
                let judged = self.judge(reply, film, Some(&earlier.task.name))?;
                if !judged.outcome.passes() {
                    return Ok(Some(format!("it fails the group `{}`", group.name)));
                }
            }
        }
        Ok(None)
    }
}
