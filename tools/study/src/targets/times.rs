//! What kernels cost, relative to each other.

use super::PLAIN;
use super::before::COSTS;
use crate::result::{Speed, Target};

/// Costs may be larger by this one: the machine is another, and so is the compiler. To be
/// cheaper is no fault.
const OF_COSTS: f64 = 1.5;

pub fn targets(speeds: &[Speed]) -> Vec<Target> {
    let of_each = COSTS.iter().filter_map(|cost| costing(speeds, cost));
    cost_of_f64_on_f32(speeds)
        .into_iter()
        .chain(of_each)
        .collect()
}

fn cost_of_f64_on_f32(speeds: &[Speed]) -> Option<Target> {
    let sum = |numbers: &str| -> f64 {
        let of = speeds
            .iter()
            .filter(|s| s.numbers == numbers && PLAIN.contains(&s.kernel.as_str()));
        of.map(|speed| speed.nanoseconds).sum()
    };
    let ratio = sum("f64 on f32") / sum("f32");
    ratio.is_finite().then(|| Target {
        about: "the same kernels: cost of f64 on f32 data over f32".into(),
        expected: "1.17".into(),
        measured: format!("{ratio:.2}"),
        met: ratio <= OF_COSTS * 1.17,
        is_time: true,
    })
}

fn costing(speeds: &[Speed], (shape, kernel, ratio): &(&str, &str, f64)) -> Option<Target> {
    let speed = speeds
        .iter()
        .find(|s| s.shape == *shape && s.kernel == *kernel && s.numbers == "f64")?;
    Some(Target {
        about: format!("{shape} {kernel}: cost over the fastest, f64"),
        expected: format!("{ratio:.2}"),
        measured: format!("{:.2}", speed.ratio),
        met: speed.ratio <= OF_COSTS * ratio,
        is_time: true,
    })
}
