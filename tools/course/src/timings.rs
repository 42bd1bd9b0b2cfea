//! How long each stage takes, summed over all threads.
//!
//! Stages begin and end deep inside other code. Their times are kept in one place for the whole
//! process, so that no call needs to pass them.

use std::fmt;
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

use serde::Serialize;

/// A stage and what it took.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Stage {
    /// What was done.
    pub name: String,
    /// How many times it ran.
    pub times: usize,
    /// Seconds on the clock, summed. Stages run at the same time, so their sum may exceed the
    /// time of the whole run.
    pub seconds: f64,
}

static STAGES: Mutex<Vec<Stage>> = Mutex::new(Vec::new());

/// Does some work and adds its time to a stage.
pub fn timed<T>(stage: &str, work: impl FnOnce() -> T) -> T {
    let start = Instant::now();
    let done = work();
    add(stage, start.elapsed());
    done
}

/// Adds a time to a stage.
pub fn add(stage: &str, time: Duration) {
    let mut stages = STAGES.lock().unwrap_or_else(PoisonError::into_inner);
    let seconds = time.as_secs_f64();
    match stages.iter_mut().find(|known| known.name == stage) {
        Some(known) => {
            known.times += 1;
            known.seconds += seconds;
        }
        None => stages.push(Stage {
            name: stage.into(),
            times: 1,
            seconds,
        }),
    }
}

/// All stages so far.
#[derive(Clone, Debug, Serialize)]
#[serde(transparent)]
pub struct Timings(Vec<Stage>);

impl Timings {
    /// The stages of this process so far, in the order they began.
    pub fn so_far() -> Timings {
        Timings(
            STAGES
                .lock()
                .unwrap_or_else(PoisonError::into_inner)
                .clone(),
        )
    }
}

impl fmt::Display for Timings {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(
            f,
            "{:<32} {:>6} {:>9} {:>9}",
            "stage", "times", "seconds", "each"
        )?;
        for Stage {
            name,
            times,
            seconds,
        } in &self.0
        {
            let each = seconds / *times as f64;
            writeln!(f, "{name:<32} {times:>6} {seconds:>9.3} {each:>9.3}")?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_times_of_a_stage_are_summed() {
        assert_eq!(timed("summed here", || 7), 7);
        add("summed here", Duration::from_millis(250));
        let Timings(stages) = Timings::so_far();
        let stage = stages.iter().find(|stage| stage.name == "summed here");
        let stage = stage.expect("it was entered");
        assert_eq!(stage.times, 2);
        assert!(stage.seconds >= 0.25, "{stage:?}");
    }
}
