//! Grades submissions in parallel.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use super::cache::ResultCache;
use super::class::Change;
use super::grader::{Grade, Grader};
use super::intake::{self, Entry};
use super::record::{Record, RecordSummary};
use super::views::progress::GradingProgress;

/// The submissions that are to be graded.
pub struct GradeQueue<'a> {
    pub grader: &'a Grader<'a>,
    pub cache: &'a ResultCache,
    pub progress: GradingProgress<'a>,
    /// Called with the results so far, from time to time and before submissions that exceeded a
    /// time limit are graded again.
    pub so_far: &'a (dyn Fn(&[QueueResult]) + Sync),
}

/// How often results so far are written.
const PAUSE: Duration = Duration::from_secs(10);

/// The result of one submission.
pub struct QueueResult {
    pub record: RecordSummary,
    /// Whether it was graded in this run.
    pub is_new: bool,
    pub change: Option<Change>,
    /// The submission, if grading it failed in this run, and why.
    pub fault: Option<(String, String)>,
}

fn locked<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

impl GradeQueue<'_> {
    /// Grades all entries, `jobs` at a time. A submission that exceeds a time limit while others
    /// are graded is graded again at the end, alone.
    pub fn work(&self, entries: &[Entry], jobs: usize) -> Vec<QueueResult> {
        let next = AtomicUsize::new(0);
        let all = Mutex::new((Vec::new(), Instant::now()));
        let late = Mutex::new(Vec::new());
        std::thread::scope(|scope| {
            for _ in 0..jobs.clamp(1, entries.len().max(1)) {
                scope.spawn(|| {
                    while let Some(entry) = entries.get(next.fetch_add(1, Ordering::Relaxed)) {
                        match self.one(entry, false) {
                            Some(done) => {
                                let (all, told) = &mut *locked(&all);
                                all.push(done);
                                if told.elapsed() > PAUSE {
                                    (self.so_far)(all);
                                    *told = Instant::now();
                                }
                            }
                            None => locked(&late).push(entry),
                        }
                    }
                });
            }
        });
        let (mut all, _) = all.into_inner().unwrap_or_else(PoisonError::into_inner);
        let late = late.into_inner().unwrap_or_else(PoisonError::into_inner);
        for entry in &late {
            (self.so_far)(&all);
            self.progress.again_alone(&entry.id);
            all.extend(self.one(entry, true));
        }
        all
    }

    /// Grades one submission; `None` if it must be graded again, `alone`.
    fn one(&self, entry: &Entry, alone: bool) -> Option<QueueResult> {
        let done = self.grade(entry, alone)?;
        self.progress.graded(&done.record, done.is_new);
        Some(done)
    }

    fn grade(&self, entry: &Entry, alone: bool) -> Option<QueueResult> {
        let assignment = self.grader.assignment;
        let before = self.cache.get(&entry.id);
        let submission = match &entry.submission {
            Ok(submission) => submission,
            Err(why) => {
                let nothing = intake::without_answers(entry, assignment);
                let record = self.grader.blank(entry, &nothing);
                return Some(self.faulty(record.not_graded(why.clone()), None));
            }
        };
        let Grade {
            record,
            report,
            evidence,
        } = self.grader.grade(entry, submission, alone)?;
        let (Some(report), Some(evidence)) = (report, evidence) else {
            return Some(self.faulty(record, before));
        };
        if let Err(error) = self.cache.put(&record, &report, &evidence) {
            return Some(self.faulty(record.not_graded(error.to_string()), before));
        }
        let listed = self.cache.listed(&entry.id);
        let change = listed.and_then(|listed| Change::between(&listed, &record));
        Some(QueueResult {
            record: record.into(),
            is_new: true,
            change,
            fault: None,
        })
    }

    /// Records a fault of ours. The grade from `before` stays valid if the answers, goldens,
    /// tools and settings are the same.
    fn faulty(&self, mut record: Record, before: Option<Record>) -> QueueResult {
        if let Err(error) = self.cache.put_fault(&record) {
            record.explanation.push_str(&format!("; {}", error.problem));
        }
        let fault = Some((record.id.clone(), record.explanation.clone()));
        let stands = before.filter(|before| before.provenance == record.provenance);
        QueueResult {
            is_new: stands.is_none(),
            record: stands.unwrap_or(record).into(),
            change: None,
            fault,
        }
    }
}
