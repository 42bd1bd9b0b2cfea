//! The one path: compile a submission, ask it, judge what it answers, just as `check`.

mod base;

use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Duration;

pub use base::Base;

use rayon::iter::{IndexedParallelIterator, IntoParallelRefIterator, ParallelIterator};

use pinhole_course::assignment::Assignment;
use pinhole_course::compile::{Compiler, Program};
use pinhole_course::error::Result;
use pinhole_course::examine::{Examiner, KnownReplies, Selection};
use pinhole_course::goldens::Goldens;
use pinhole_course::outcome::Examination;
use pinhole_course::progress::Progress;
use pinhole_course::sandbox::Sandbox;
use pinhole_course::second_judge::SecondJudge;
use pinhole_course::submission::Submission;

/// What every submission is judged with.
#[derive(Clone, Copy)]
pub struct Validator<'a> {
    /// Whose tasks.
    pub assignment: &'a Assignment,
    /// By what.
    pub goldens: &'a Goldens,
    /// Questions from another seed, by which sentences are tested, if there are any.
    pub fresh: Option<&'a Goldens>,
    /// Makes programs.
    pub compiler: &'a Compiler,
    /// Where they run.
    pub sandbox: &'a Sandbox,
    /// Asked about every film too, if there is one.
    pub second_judge: Option<&'a SecondJudge>,
    /// As many at a time as this has threads.
    pub pool: &'a rayon::ThreadPool,
    /// Told how far it is.
    pub progress: &'a Progress,
}

/// As long as `check` gives an answer.
pub const WALL: Duration = Duration::from_secs(30);

impl Validator<'_> {
    /// Does the same work on all items, as many at a time as the pool has threads.
    /// Results come in the items' order.
    pub fn all<T: Sync, R: Send>(
        &self,
        what: &str,
        items: &[T],
        work: impl Fn(&T) -> Result<R> + Sync,
    ) -> Result<Vec<R>> {
        let done = AtomicUsize::new(0);
        let told = |item| {
            let result = work(item);
            let done = 1 + done.fetch_add(1, Ordering::Relaxed);
            self.progress.show(what, done as f64 / items.len() as f64);
            result
        };
        self.progress.say(what);
        self.pool
            .install(|| items.par_iter().with_max_len(1).map(told).collect())
    }

    /// Compiles a submission and asks it what is selected.
    pub fn examine(&self, submission: &Submission, selection: &Selection) -> Result<Examination> {
        let program = self.compiler.compile(submission)?;
        self.examine_built(&program, submission, selection, WALL, None)
    }

    /// The same for everything, but what is answered by the files of `base` alone is asked
    /// of one submission only.
    pub fn examine_over(&self, submission: &Submission, base: &Base) -> Result<Examination> {
        let program = self.compiler.compile(submission)?;
        let known = base.replies_for(submission, self)?;
        let everything = Selection::default();
        self.examine_built(&program, submission, &everything, WALL, Some(&known))
    }

    /// Asks a built submission what is selected, for at most `wall` a task or scene.
    pub fn examine_built(
        &self,
        program: &Program,
        submission: &Submission,
        selection: &Selection,
        wall: Duration,
        known: Option<&dyn KnownReplies>,
    ) -> Result<Examination> {
        let examiner = Examiner {
            assignment: self.assignment,
            goldens: self.goldens,
            program,
            sandbox: self.sandbox,
            wall,
            interactive: false,
            second_judge: self.second_judge,
            clock: None,
            known,
            progress: &|_, _| {},
        };
        examiner.examine(submission, selection)
    }
}
