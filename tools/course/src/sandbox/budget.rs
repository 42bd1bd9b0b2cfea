//! The limits that one submission may run into.
//!
//! Code that runs into its limit in every group and every scene would take a hundred times that
//! limit. Answers that arrive cost nothing here, so a slow but right submission loses nothing.

use std::sync::Arc;
use std::sync::atomic::{AtomicU32, Ordering};

use super::Limits;

/// How many limits one submission has run into so far; clones count together.
#[derive(Clone, Debug, Default)]
pub struct Budget {
    lost: Arc<AtomicU32>,
}

/// After this many, everything else gets only its shortest time.
const MOST_LOST: u32 = 2;

impl Budget {
    /// Shorter limits, if too many have been lost already.
    pub fn bound(&self, limits: Limits) -> Limits {
        match self.lost.load(Ordering::Relaxed) >= MOST_LOST {
            true => limits.shortened(),
            false => limits,
        }
    }

    /// Counts one limit that was exceeded.
    pub fn charge(&self) {
        self.lost.fetch_add(1, Ordering::Relaxed);
    }
}

#[cfg(test)]
mod tests {
    use std::time::Duration;

    use super::*;

    #[test]
    fn limits_become_short_after_two_but_never_shorter_than_is_fair() {
        let budget = Budget::default();
        let seconds = Duration::from_secs;
        let limits = Limits::of_processor(seconds(16), seconds(9));
        budget.clone().charge();
        assert_eq!(budget.bound(limits), limits);
        budget.charge();
        assert_eq!(budget.bound(limits).cpu, seconds(9));
        assert_eq!(budget.bound(limits).wall, seconds(20));
    }
}
