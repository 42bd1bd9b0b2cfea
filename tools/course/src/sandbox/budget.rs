//! The time that one submission may take, and the limits that it may run into.
//!
//! Without these bounds, code that runs into its limit in every group and every scene would take a
//! hundred times that limit. Answers that arrive in time cost nothing here, so a slow but right
//! submission loses nothing.

use std::sync::atomic::{AtomicBool, AtomicU32, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

use pinhole::ask::BUSY;

use super::Limits;

/// What one submission may still use; clones share one count.
#[derive(Clone, Debug, Default)]
pub struct Budget {
    /// How many limits it has run into so far.
    lost: Arc<AtomicU32>,
    /// When it began, and how long it may take in total on the clock; `None` unless a class is
    /// being graded.
    whole: Option<(Instant, Duration)>,
    /// How long other programs kept it from running.
    starved: Arc<Mutex<Duration>>,
    /// Whether it exceeded a limit while other programs had most of the time.
    has_starved: Arc<AtomicBool>,
}

/// After this many exceeded limits, everything else gets only its shortest time.
const MOST_LOST: u32 = 2;

/// Nothing is started with less time than this. If bubblewrap is killed while it makes its
/// namespaces, which takes it a small part of this time, it leaves a process behind.
const LEAST: Duration = Duration::from_secs(1);

/// Compiling may take the whole time divided by this. Right answers take a hundredth.
const COMPILING: u32 = 4;

impl Budget {
    /// For a submission that begins now and may take `whole` in total.
    #[cfg_attr(not(target_os = "linux"), expect(dead_code))]
    pub fn of(whole: Duration) -> Budget {
        Budget {
            whole: Some((Instant::now(), whole)),
            ..Budget::default()
        }
    }

    /// The time that is left on the clock; if that is too little to start anything, how much there
    /// was in total. The time in which it was kept from running doesn't count, unless that is nearly
    /// all of it: see [`BUSY`].
    pub fn left(&self) -> Result<Duration, Duration> {
        let Some((begun, whole)) = self.whole else {
            return Ok(Duration::MAX);
        };
        let starved = self.starved();
        match (whole + starved.min(whole * (BUSY - 1))).saturating_sub(begun.elapsed()) {
            left if left < LEAST => Err(whole),
            left => Ok(left),
        }
    }

    /// Whether it exceeded a limit perhaps only because other programs kept it from running.
    pub fn is_starved(&self) -> bool {
        let is_long = |(_, whole)| self.starved() > whole;
        let is_out_of_time = self.left().is_err() && self.whole.is_some_and(is_long);
        is_out_of_time || self.has_starved.load(Ordering::Relaxed)
    }

    fn starved(&self) -> Duration {
        *self.starved.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Whether compiling has used up its share of the time.
    pub fn is_done_compiling(&self) -> bool {
        let spent = |(begun, whole): (Instant, Duration)| {
            begun.elapsed().saturating_sub(self.starved()) >= whole / COMPILING
        };
        self.whole.is_some_and(spent)
    }

    /// Shortens limits, if too many have been exceeded already.
    pub fn bound(&self, limits: Limits) -> Limits {
        match self.lost.load(Ordering::Relaxed) >= MOST_LOST {
            true => limits.shortened(),
            false => limits,
        }
    }

    /// Counts time in which other programs kept it from running.
    pub fn add_starved(&self, time: Duration) {
        *self.starved.lock().unwrap_or_else(PoisonError::into_inner) += time;
    }

    /// Counts one limit that was exceeded, perhaps only because other programs took most of the time.
    pub fn charge(&self, is_starved: bool) {
        self.lost.fetch_add(1, Ordering::Relaxed);
        self.has_starved.fetch_or(is_starved, Ordering::Relaxed);
    }

    /// Takes one of these limits back, because what was asked is asked again.
    pub fn forgive(&self) {
        let less = |lost: u32| Some(lost.saturating_sub(1));
        let _before = self
            .lost
            .fetch_update(Ordering::Relaxed, Ordering::Relaxed, less);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_submission_that_stays_below_every_limit_runs_out_of_time() {
        let moment = Duration::from_millis(20);
        let budget = Budget::of(moment);
        std::thread::sleep(moment);
        assert_eq!(budget.clone().left(), Err(moment));
        assert!(budget.is_done_compiling() && !Budget::default().is_done_compiling());
        let hour = Duration::from_secs(3600);
        assert!(Budget::of(hour).left().is_ok_and(|left| left <= hour));
        assert!(Budget::of(Duration::from_millis(900)).left().is_err());
        assert!(!Budget::of(hour).is_done_compiling());
        assert_eq!(Budget::default().left(), Ok(Duration::MAX));
    }

    #[test]
    fn time_in_which_others_ran_is_given_back_up_to_nineteen_times() {
        let begun = Instant::now() - Duration::from_secs(15);
        let budget = Budget {
            whole: Some((begun, Duration::from_secs(10))),
            ..Budget::default()
        };
        assert!(budget.left().is_err());
        budget.clone().add_starved(Duration::from_secs(8));
        assert!(
            budget
                .left()
                .is_ok_and(|left| left <= Duration::from_secs(3))
        );
        assert!(!budget.is_starved() && budget.is_done_compiling());
        budget.add_starved(Duration::from_secs(6));
        assert!(!budget.is_done_compiling());
        let begun = Instant::now() - Duration::from_secs(150);
        let [starved, slow] = [145, 8].map(|seconds| Budget {
            whole: Some((begun, Duration::from_secs(10))),
            starved: Arc::new(Mutex::new(Duration::from_secs(seconds))),
            ..Budget::default()
        });
        assert!(starved.left().is_ok() && !starved.is_starved());
        starved.add_starved(Duration::from_secs(1000));
        assert!(starved.left().is_ok(), "it may take 200 s");
        assert!(slow.left().is_err() && !slow.is_starved());
        let begun = Instant::now() - Duration::from_secs(201);
        let starved = Budget {
            whole: Some((begun, Duration::from_secs(10))),
            ..starved
        };
        assert!(starved.left().is_err() && starved.is_starved());
        for is_starved in [false, true] {
            let budget = Budget::default();
            budget.clone().charge(is_starved);
            assert_eq!(budget.is_starved(), is_starved);
        }
    }

    #[test]
    fn limits_become_short_after_two_but_never_shorter_than_is_fair() {
        let budget = Budget::default();
        let seconds = Duration::from_secs;
        let limits = Limits::of_processor(seconds(16), seconds(9));
        budget.clone().charge(false);
        assert_eq!(budget.bound(limits), limits);
        budget.charge(false);
        assert_eq!(budget.bound(limits).cpu, seconds(9));
        assert_eq!(budget.bound(limits).silence, seconds(20));
        budget.forgive();
        assert_eq!(budget.bound(limits), limits);
    }
}
