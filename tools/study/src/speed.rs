//! How long a kernel takes.
//!
//! All contestants of a shape take turns, round after round, so that whatever slows the
//! machine slows all of them; of each the median round counts, in CPU time of this
//! thread, which other programs do not lengthen.

use std::time::Duration;

use crate::contestant::{Contestant, Workload};
use crate::family::{Studied, questions};
use crate::question::Data;

/// Pairs of ray and shape in a workload: few enough to stay in a core's own cache.
pub const PAIRS: usize = 2048;
/// Casts of the whole workload in a round.
const REPEATS: u32 = 8;

/// What was measured of one contestant.
#[derive(Clone, Debug)]
pub struct Time {
    /// Median over all rounds.
    pub nanoseconds: f64,
    /// The difference of the quartiles over the median.
    pub spread: f64,
}

/// CPU time of this thread.
#[cfg(unix)]
pub fn now() -> Duration {
    let time = rustix::time::clock_gettime(rustix::time::ClockId::ThreadCPUTime);
    Duration::new(time.tv_sec as u64, time.tv_nsec as u32)
}

/// Wall time, where a thread's own is not to be had.
#[cfg(not(unix))]
pub fn now() -> Duration {
    use std::sync::LazyLock;
    use std::time::Instant;
    static START: LazyLock<Instant> = LazyLock::new(Instant::now);
    START.elapsed()
}

/// The workload of a kernel: the first family at the second step, an everyday scene of
/// which about half of the rays hit.
pub fn workload<S: Studied>(kernel: &Contestant<S>, seed: u64) -> Workload {
    let families = S::families();
    let everyday = families.iter().find(|family| family.name == "offset");
    let everyday = everyday.expect("every shape has an offset");
    (kernel.workload)(&questions(everyday, 0, kernel.data, PAIRS, seed))
}

/// Times of all contestants with one type of data, in their order.
pub fn race<S: Studied>(
    kernels: &[Contestant<S>],
    data: Data,
    rounds: usize,
    seed: u64,
) -> Vec<Time> {
    let entered = kernels.iter().filter(|kernel| kernel.data == data);
    let mut workloads: Vec<_> = entered.map(|kernel| workload(kernel, seed)).collect();
    let mut times = vec![Vec::with_capacity(rounds); workloads.len()];
    for round in 0..=rounds {
        for (cast, times) in workloads.iter_mut().zip(&mut times) {
            let start = now();
            for _ in 0..REPEATS {
                cast();
            }
            // The first round warms caches and predictors.
            if round > 0 {
                times.push((now() - start).as_secs_f64() * 1e9);
            }
        }
    }
    let casts = f64::from(REPEATS) * PAIRS as f64;
    times
        .into_iter()
        .map(|times| of_rounds(times, casts))
        .collect()
}

fn of_rounds(mut times: Vec<f64>, casts: f64) -> Time {
    times.sort_by(f64::total_cmp);
    let at = |share: f64| times[((times.len() - 1) as f64 * share) as usize] / casts;
    Time {
        nanoseconds: at(0.5),
        spread: (at(0.75) - at(0.25)) / at(0.5),
    }
}
