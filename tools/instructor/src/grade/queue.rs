//! Grades submissions in parallel and skips those whose result is still valid.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};

use super::cache::ResultCache;
use super::class::Change;
use super::grader::{Grade, Grader};
use super::intake::{self, Entry};
use super::provenance::Provenance;
use super::record::Record;
use super::views::progress::GradingProgress;
use pinhole_course::submission::Unusable;

/// The submissions that are to be graded.
pub struct GradeQueue<'a> {
    pub grader: &'a Grader<'a>,
    pub cache: &'a ResultCache,
    /// Whether to grade again what has a valid result already.
    pub regrade: bool,
    pub progress: GradingProgress<'a>,
}

/// The result of one submission.
pub struct QueueResult {
    pub record: Record,
    /// Whether it was graded in this run.
    pub is_new: bool,
    pub change: Option<Change>,
    /// Whose grading failed now, and why.
    pub fault: Option<(String, String)>,
}

fn locked<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

impl GradeQueue<'_> {
    /// Grades all entries, `jobs` at a time. One that is late beside others is graded
    /// again when all others are done.
    pub fn work(&self, entries: &[Entry], jobs: usize) -> Vec<QueueResult> {
        let next = AtomicUsize::new(0);
        let all = Mutex::new(Vec::new());
        let late = Mutex::new(Vec::new());
        std::thread::scope(|scope| {
            for _ in 0..jobs.clamp(1, entries.len().max(1)) {
                scope.spawn(|| {
                    while let Some(entry) = entries.get(next.fetch_add(1, Ordering::Relaxed)) {
                        match self.one(entry, false) {
                            Some(done) => locked(&all).push(done),
                            None => locked(&late).push(entry),
                        }
                    }
                });
            }
        });
        let mut all = all.into_inner().unwrap_or_else(PoisonError::into_inner);
        let late = late.into_inner().unwrap_or_else(PoisonError::into_inner);
        for entry in &late {
            self.progress.again_alone(&entry.id);
            all.extend(self.one(entry, true));
        }
        all
    }

    /// `None` if it is to be graded again, `alone`.
    fn one(&self, entry: &Entry, alone: bool) -> Option<QueueResult> {
        let done = self.grade(entry, alone)?;
        self.progress.graded(&done.record, done.is_new);
        Some(done)
    }

    fn grade(&self, entry: &Entry, alone: bool) -> Option<QueueResult> {
        let Grader {
            assignment,
            made_with,
            ..
        } = self.grader;
        let before = self.cache.get(&entry.id);
        let submission = match intake::open(entry, assignment) {
            Ok(submission) => submission,
            Err(error) => {
                let missing = Unusable::Missing;
                let nothing = intake::without_answers(entry, assignment, &missing);
                let record = self.grader.blank(entry, &nothing);
                return Some(self.faulty(record.not_graded(error.to_string()), None));
            }
        };
        if let Some(before) = &before
            && !self.regrade
            && before.provenance == Provenance::of(&submission, made_with)
            && before.got.submission == entry.name
        {
            return Some(QueueResult {
                record: before.clone(),
                is_new: false,
                change: None,
                fault: None,
            });
        }
        let Grade { record, report } = self.grader.grade(entry, &submission, alone)?;
        let Some(report) = report else {
            return Some(self.faulty(record, before));
        };
        if let Err(error) = self.cache.put(&record, &report) {
            return Some(self.faulty(record.not_graded(error.to_string()), before));
        }
        let change = before.and_then(|before| Change::between(&before, &record));
        Some(QueueResult {
            record,
            is_new: true,
            change,
            fault: None,
        })
    }

    /// A fault of ours. It is reported and kept, but the grade from `before` stands if the
    /// same answers would be judged by the same goldens, tools and settings.
    fn faulty(&self, mut record: Record, before: Option<Record>) -> QueueResult {
        if let Err(error) = self.cache.put_fault(&record) {
            record.explanation.push_str(&format!("; {}", error.problem));
        }
        let fault = Some((record.id.clone(), record.explanation.clone()));
        let stands = before.filter(|before| before.provenance == record.provenance);
        QueueResult {
            is_new: stands.is_none(),
            record: stands.unwrap_or(record),
            change: None,
            fault,
        }
    }
}
