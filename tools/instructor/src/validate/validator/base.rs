//! Answers that many submissions share, and their replies.
//!
//! A known mistake changes one answer file of the reference. A task is answered by its own file,
//! and a scene by the files of the tasks it needs. So everything that doesn't depend on the
//! changed file is asked once, and not again for each mistake.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::{Mutex, PoisonError};

use pinhole::ask::Reply;

use super::Validator;
use pinhole_course::assignment::{Assignment, Task};
use pinhole_course::error::Result;
use pinhole_course::examine::KnownReplies;
use pinhole_course::submission::Submission;

/// Answers, and their replies so far.
pub struct Base {
    /// The answers.
    pub submission: Submission,
    /// By task or scene, and the number of questions: a task's may be asked in several batches.
    replies: Mutex<BTreeMap<(String, usize), Reply>>,
}

/// The replies of a base that also apply to a submission laid over it.
pub struct RepliesInCommon<'a> {
    base: &'a Base,
    /// The tasks and scenes that are answered by files of the base alone.
    unchanged: BTreeSet<String>,
}

impl Base {
    /// A base that has not been asked anything yet.
    pub fn new(submission: Submission) -> Base {
        Base {
            submission,
            replies: Mutex::default(),
        }
    }

    /// What this base and a submission laid over it have in common.
    pub fn replies_for(
        &self,
        submission: &Submission,
        validator: &Validator,
    ) -> Result<RepliesInCommon<'_>> {
        let tasks = &validator.assignment.tasks;
        let is_changed = |task: &&Task| {
            let answer = |whose: &Submission| {
                let mut answers = whose.answers.iter();
                answers.find(|answer| answer.task == task.name).cloned()
            };
            answer(&self.submission) != answer(submission)
        };
        let changed: Vec<&Task> = tasks.iter().filter(is_changed).collect();
        let mut unchanged = BTreeSet::new();
        if is_apart(submission, validator.assignment) {
            let same = tasks.iter().filter(|task| !is_changed(task));
            unchanged.extend(same.map(|task| task.name.clone()));
            for scene in &validator.goldens.scenes {
                let job = &validator.goldens.cached_scene(scene)?.job;
                if !changed.iter().any(|task| job.needs(task.kind, task.shape)) {
                    unchanged.insert(scene.name.clone());
                }
            }
        }
        Ok(RepliesInCommon {
            base: self,
            unchanged,
        })
    }
}

/// Whether no answer calls another directly or keeps state. Otherwise, one file could affect the
/// tasks of others.
fn is_apart(submission: &Submission, assignment: &Assignment) -> bool {
    let fixed = assignment.fixed_files();
    let mut answers = submission.answers.iter();
    answers.all(|answer| {
        let text = answer.text.as_deref().unwrap_or_default();
        stands_alone(text, &fixed)
    })
}

/// Whether an answer names no module of its crate except the fixed files, and no `static`.
fn stands_alone(text: &str, fixed: &[String]) -> bool {
    let is_fixed = |path: &str| {
        let mut modules = fixed.iter().filter_map(|file| file.strip_suffix(".rs"));
        modules.any(|module| path.starts_with(&format!("{module}::")))
    };
    let mut paths = text.split("crate::").skip(1);
    paths.all(is_fixed) && !text.contains("super::") && !text.contains("static ")
}

impl KnownReplies for RepliesInCommon<'_> {
    fn get(&self, what: &str, questions: usize) -> Option<Reply> {
        let replies = &self.base.replies;
        let replies = replies.lock().unwrap_or_else(PoisonError::into_inner);
        let is_same = self.unchanged.contains(what);
        let key = (what.to_owned(), questions);
        replies.get(&key).filter(|_| is_same).cloned()
    }

    fn keep(&self, what: &str, reply: &Reply) {
        if self.unchanged.contains(what) {
            let replies = &self.base.replies;
            let mut replies = replies.lock().unwrap_or_else(PoisonError::into_inner);
            replies.insert((what.into(), reply.answers.len()), reply.clone());
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn answer_that_uses_others_or_keeps_state_is_not_judged_alone() {
        let fixed = ["main.rs".to_owned(), "ours.rs".to_owned()];
        for (text, alone) in [
            ("use crate::ours::Trait;", true),
            ("use crate::ours::Trait; use crate::theirs::helper;", false),
            ("use crate::ours_too::Trait;", false),
            ("use super::theirs;", false),
            ("static COUNT: AtomicUsize = AtomicUsize::new(0);", false),
        ] {
            assert_eq!(stands_alone(text, &fixed), alone, "{text}");
        }
    }
}
