//! The time that one submission may lose to timeouts in all.
//!
//! Code that waits for its limit in every group and every scene would take a hundred
//! times that limit. Only what ran into a limit is counted: answers that come are
//! free, so a submission that is slow and right loses nothing.

use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::Duration;

use super::Limits;

/// Seconds lost so far by one submission; clones count together.
#[derive(Clone, Debug, Default)]
pub struct Budget {
    lost_millis: Arc<AtomicU64>,
}

/// Once this many whole limits are lost, every further question gets only its shortest
/// time.
const MOST_LOST: u32 = 4;

impl Budget {
    /// Shorter limits, if too much has been lost already.
    pub fn bound(&self, limits: Limits) -> Limits {
        let lost = Duration::from_millis(self.lost_millis.load(Ordering::Relaxed));
        match lost >= limits.wall * MOST_LOST {
            true => limits.at_most(limits.shortest),
            false => limits,
        }
    }

    /// Counts one limit that was run into.
    pub fn charge(&self, lost: Duration) {
        let millis = lost.as_millis().try_into().unwrap_or(u64::MAX);
        self.lost_millis.fetch_add(millis, Ordering::Relaxed);
    }
}
