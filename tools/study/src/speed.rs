//! Measures how long kernels take, and counts their instructions.
//!
//! All kernels of a shape take turns, round after round, so that anything that slows the
//! machine slows all of them. The result is each kernel's median round, in CPU time of this
//! thread, which other programs do not lengthen. The instructions of a kernel or a scene are
//! counted with callgrind. Unlike times, they repeat exactly.

use std::env;
use std::process::Command;
use std::time::Duration;

use pinhole_course::rust_tool::programs;

pub use crate::contestants::Workload;
use crate::family::{Family, HasFamilies, questions, steps};
use crate::question::{Class, Data, Question};

/// Pairs of ray and shape in a workload: few enough to stay in a core's own cache.
pub const PAIRS: usize = 2048;

/// The measured time of one workload.
#[derive(Clone, Debug)]
pub struct Time {
    /// Median over all rounds, for one pair.
    pub nanoseconds: f64,
    /// Half the width of the median's 95 % confidence interval, divided by the median.
    pub spread: f64,
}

/// CPU time of this thread.
#[cfg(unix)]
pub fn now() -> Duration {
    let time = rustix::time::clock_gettime(rustix::time::ClockId::ThreadCPUTime);
    Duration::new(time.tv_sec as u64, time.tv_nsec as u32)
}

/// Wall time, on platforms without a thread's CPU time.
#[cfg(not(unix))]
pub fn now() -> Duration {
    use std::sync::LazyLock;
    use std::time::Instant;
    static START: LazyLock<Instant> = LazyLock::new(Instant::now);
    START.elapsed()
}

/// About `count` questions of a class, evenly from all its families and exponents: the first of
/// those that are judged.
pub fn pool<S: HasFamilies>(class: Class, data: Data, count: usize, seed: u64) -> Vec<Question<S>> {
    let steps = steps(data).filter(|(family, x): &(Family<S>, i32)| family.class(*x) == class);
    let steps: Vec<_> = steps.collect();
    let each = count.div_ceil(steps.len().max(1));
    let asked = steps.iter();
    let asked = asked.map(|(family, exponent)| questions(family, *exponent, data, each, seed));
    let asked: Vec<_> = asked.collect();
    // Interleave the families, so that the branch predictor cannot learn one.
    (0..each)
        .flat_map(|at| asked.iter().filter_map(move |asked| asked.get(at).copied()))
        .collect()
}

/// Times workloads of `pairs` pairs each, in turn. Each gets `seconds` seconds, but at least
/// nine rounds. The results are for one pair.
pub fn race(mut workloads: Vec<Workload>, pairs: usize, seconds: f64) -> Vec<Time> {
    let mut times = vec![Vec::new(); workloads.len()];
    let mut is_any_left = true;
    while is_any_left {
        is_any_left = false;
        for (cast, times) in workloads.iter_mut().zip(&mut times) {
            let spent: f64 = times.iter().sum();
            if times.len() > 9 && spent > seconds * 1e9 {
                continue;
            }
            is_any_left = true;
            let start = now();
            cast();
            times.push((now() - start).as_secs_f64() * 1e9);
        }
    }
    // The first round warms caches and predictors.
    let of_rounds = |times: Vec<f64>| of_rounds(times[1..].to_vec(), pairs as f64);
    times.into_iter().map(of_rounds).collect()
}

/// The median and its confidence interval by order statistics: n/2 ± 0.98 √n (Conover,
/// *Practical Nonparametric Statistics*, 3rd ed., §3.2).
fn of_rounds(mut times: Vec<f64>, casts: f64) -> Time {
    times.sort_by(f64::total_cmp);
    let (middle, half) = (times.len() / 2, 0.98 * (times.len() as f64).sqrt());
    let at = |place: f64| times[(place.max(0.0) as usize).min(times.len() - 1)];
    let width = at(middle as f64 + half.ceil()) - at(middle as f64 - half.ceil());
    Time {
        nanoseconds: times[middle] / casts,
        spread: width / 2.0 / times[middle],
    }
}

/// What the program prints when it has finished all its casts.
pub const DONE: &str = "cast\n";

/// Instructions per ray of one way to cast something; `None` without valgrind.
///
/// Runs this program under valgrind twice, with different numbers of casts, and divides the
/// difference. This excludes start-up and set-up.
pub fn instructions(what: &str, way: usize, rays: usize) -> Option<f64> {
    let with = |casts: u32| {
        let mut valgrind = Command::new(programs("valgrind").next()?);
        valgrind.args(["--tool=callgrind", "--callgrind-out-file=/dev/null"]);
        valgrind.arg(env::current_exe().ok()?);
        valgrind.args(["cast", what, &way.to_string(), &casts.to_string()]);
        let output = valgrind.output().ok()?;
        // Valgrind reports a count even for a program that crashes half-way.
        output.stdout.ends_with(DONE.as_bytes()).then_some(())?;
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        let line = said.lines().find(|line| line.contains("Collected :"))?;
        line.rsplit(' ').next()?.parse::<f64>().ok()
    };
    Some((with(3)? - with(1)?) / (2.0 * rays as f64))
}
