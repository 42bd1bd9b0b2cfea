//! What plans promise: to keep to the accuracy, and to be cheaper than what is more
//! accurate.

use super::counted;
use crate::result::{PlanTally, Target};

type Ratio = fn(&PlanTally) -> f64;

pub fn targets(plans: &[PlanTally]) -> Vec<Target> {
    if plans.is_empty() {
        return Vec::new();
    }
    let sum = |of: fn(&PlanTally) -> u64| plans.iter().map(of).sum::<u64>();
    let violations = sum(|plan| plan.violations);
    let exact = || plans.iter().filter(|plan| plan.exact_ids);
    let wrong = exact().map(|plan| plan.wrong_ids).sum();
    let mut targets = vec![
        Target {
            about: format!("{} plans: pixels off by more than was wished", plans.len()),
            expected: "0".into(),
            measured: counted(violations, sum(|plan| plan.rays)),
            met: violations == 0,
            is_time: false,
        },
        Target {
            about: "plans with exact ids: wrong objects".into(),
            expected: "0".into(),
            measured: counted(wrong, exact().map(|plan| plan.rays).sum()),
            met: wrong == 0,
            is_time: false,
        },
    ];
    let times: [(&str, &str, Ratio, f64); 2] = [
        (
            "plans: time over the most accurate way",
            "below 1",
            |plan| plan.nanoseconds / plan.most_accurate,
            1.0,
        ),
        (
            "plans: time over the least accurate way",
            "median below 2",
            |plan| plan.nanoseconds / plan.least_accurate,
            2.0,
        ),
    ];
    for (about, expected, ratio, limit) in times {
        let mut ratios: Vec<f64> = plans.iter().map(ratio).collect();
        ratios.sort_by(f64::total_cmp);
        let (median, worst) = (ratios[ratios.len() / 2], ratios[ratios.len() - 1]);
        targets.push(Target {
            about: about.into(),
            expected: expected.into(),
            measured: format!("median {median:.2}, worst {worst:.2}"),
            met: median < limit,
            is_time: true,
        });
    }
    targets
}
