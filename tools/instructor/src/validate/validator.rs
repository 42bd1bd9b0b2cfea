//! Compiles a submission, asks it, and judges its answers, as `check` does.

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

/// Everything that submissions are judged with.
#[derive(Clone, Copy)]
pub struct Validator<'a> {
    /// The assignment whose tasks are asked.
    pub assignment: &'a Assignment,
    /// The goldens that judge the answers.
    pub goldens: &'a Goldens,
    /// Questions from another seed, on which sentences are tested, if there are any.
    pub fresh: Option<&'a Goldens>,
    /// The compiler for submissions.
    pub compiler: &'a Compiler,
    /// The sandbox that programs run in.
    pub sandbox: &'a Sandbox,
    /// The second judge of every film, if there is one.
    pub second_judge: Option<&'a SecondJudge>,
    /// Threads, each of which judges one submission at a time.
    pub pool: &'a rayon::ThreadPool,
    /// The progress line.
    pub progress: &'a Progress,
}

/// How long an answer may take: as long as in `check`.
pub const WALL: Duration = Duration::from_secs(30);

impl Validator<'_> {
    /// Does some work on each item, as many at a time as the pool has threads. Results are in the
    /// items' order.
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

    /// Compiles a submission and asks it the selected questions.
    pub fn examine(&self, submission: &Submission, selection: &Selection) -> Result<Examination> {
        let program = self.compiler.compile(submission)?;
        self.examine_built(&program, submission, selection, WALL, None)
    }

    /// Asks a submission everything, but reuses replies that depend only on files of `base`.
    /// The questions behind those replies are asked only once.
    pub fn examine_over(&self, submission: &Submission, base: &Base) -> Result<Examination> {
        let program = self.compiler.compile(submission)?;
        let known = base.replies_for(submission, self)?;
        let everything = Selection::default();
        self.examine_built(&program, submission, &everything, WALL, Some(&known))
    }

    /// Asks a built submission the selected questions, for at most `wall` for each task or scene.
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
            withheld: &[],
            known,
            progress: &|_, _| {},
        };
        examiner.examine(submission, selection)
    }
}
