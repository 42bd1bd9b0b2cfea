//! The promises as data: what each is about, what was promised, and how to compute it from the
//! findings. `terminal` and `summary` print them.

use crate::contestants::EXACT;
use crate::judge::{median_and_worst, rule_of_three};
use crate::question::Class;
use crate::result::{
    ConditioningErrors, Findings, MeshTally, PlanTally, SceneTally, Target, Trade,
};

/// A measurement in words, and whether it keeps the promise.
type Measured = Option<(String, bool)>;

struct Promise {
    about: &'static str,
    expected: &'static str,
    measured: fn(&Findings) -> Measured,
    is_time: bool,
}

const PROMISES: [Promise; 16] = [
    never("exact kernels: wrong decisions, everyday", |it| {
        decisions(it, Class::Everyday, |trade| trade.kernel == EXACT)
    }),
    never("exact kernels: wrong decisions, hard", |it| {
        decisions(it, Class::Hard, |trade| trade.kernel == EXACT)
    }),
    never("exact kernels: wrong decisions, absurd", |it| {
        decisions(it, Class::Absurd, |trade| trade.kernel == EXACT)
    }),
    never("f64 on f32 data, careful kernels: wrong, everyday", |it| {
        let is_careful = |kernel: &str| CAREFUL.contains(&kernel);
        decisions(it, Class::Everyday, |trade| {
            trade.numbers == "f64 on f32" && is_careful(trade.kernel)
        })
    }),
    Promise {
        about: "exact kernels: largest error of t, f64",
        expected: "≤ 1e8 ulp",
        measured: |it| worst(&it.conditioning),
        is_time: false,
    },
    never("exact triangles: leaks at edges and corners", |it| {
        leaks(&it.meshes, EXACT)
    }),
    never("Woop, edges owned: leaks at edges and corners", |it| {
        leaks(&it.meshes, "Woop, edges owned")
    }),
    never("exact casting: wrong objects in the scenes", |it| {
        wrong_objects(&it.scenes)
    }),
    never("exact casting: wrong objects on grids", |it| {
        wrong_objects(&it.grids)
    }),
    never("plans: pixels off by more than wished", |it| {
        none_of(
            it.plans.iter().map(|plan| plan.kept.violations).sum(),
            it.plans.iter().map(|plan| plan.kept.rays).sum(),
        )
    }),
    never("plans: pixels with a wrong object", |it| {
        none_of(
            it.plans.iter().map(|plan| plan.kept.wrong_ids).sum(),
            it.plans.iter().map(|plan| plan.kept.rays).sum(),
        )
    }),
    cost(
        "exact casting: extra instructions per ray, against f64",
        "median ≤ 25, worst ≤ 50",
        |it| added(&it.scenes),
    ),
    cost(
        "exact casting on grids: instructions ÷ those of f64",
        "worst ≤ 3.00",
        |it| {
            ratios(instructions(&it.grids).map(|[p, q]| p / q), |_, worst| {
                worst <= 3.0
            })
        },
    ),
    cost(
        "plans: time ÷ that of exact objects alone",
        "worst ≤ 1.00",
        |it| {
            let ratio = |plan: &PlanTally| plan.nanoseconds / plan.exact_ids;
            ratios(it.plans.iter().map(ratio), |_, worst| worst <= 1.0)
        },
    ),
    cost("plans: time ÷ that of plain f64", "median ≤ 1.00", |it| {
        let ratio = |plan: &PlanTally| plan.nanoseconds / plan.plain;
        ratios(it.plans.iter().map(ratio), |median, _| median <= 1.0)
    }),
    cost(
        "planning: time ÷ that of a film by plain f64 with its tree",
        "worst ≤ 1.00",
        |it| {
            let ratio = |plan: &PlanTally| plan.planning / (plan.plain_tree + plan.plain);
            ratios(it.plans.iter().map(ratio), |_, worst| worst <= 1.0)
        },
    ),
];

/// Numerically careful kernels without exact decisions.
pub const CAREFUL: [&str; 3] = ["Haines scaled", "shifted origin", "Woop, edges owned"];

const fn never(about: &'static str, measured: fn(&Findings) -> Measured) -> Promise {
    Promise {
        about,
        expected: "0",
        measured,
        is_time: false,
    }
}

const fn cost(
    about: &'static str,
    expected: &'static str,
    measured: fn(&Findings) -> Measured,
) -> Promise {
    Promise {
        about,
        expected,
        measured,
        is_time: true,
    }
}

/// Compares every promise that the run has findings for.
pub fn targets(findings: &Findings) -> Vec<Target> {
    let target = |promise: &Promise| {
        let (measured, met) = (promise.measured)(findings)?;
        Some(Target {
            about: promise.about,
            expected: promise.expected,
            measured,
            met,
            is_time: promise.is_time,
        })
    };
    PROMISES.iter().filter_map(target).collect()
}

fn none_of(wrong: u64, asked: u64) -> Measured {
    let bound = match wrong {
        0 => format!(" (below {:.1e} with 95 % confidence)", rule_of_three(asked)),
        _ => String::new(),
    };
    (asked > 0).then(|| (format!("{wrong} of {asked}{bound}"), wrong == 0))
}

fn decisions(findings: &Findings, class: Class, is_it: impl Fn(&Trade) -> bool) -> Measured {
    let trades = findings.trades.iter();
    let of_class = trades.filter(|trade| trade.class == class && is_it(trade));
    let (wrong, asked) = of_class.fold((0, 0), |(wrong, asked), trade| {
        (wrong + trade.wrong + trade.not_finite, asked + trade.asked)
    });
    none_of(wrong, asked)
}

fn worst(conditioning: &[ConditioningErrors]) -> Measured {
    let exact = conditioning.iter();
    let exact = exact.filter(|it| it.kernel == EXACT && it.numbers == "f64");
    let worst = exact.map(|it| it.worst_ulp).reduce(f64::max)?;
    Some((format!("{worst:.1e} ulp"), worst <= 1e8))
}

fn leaks(meshes: &[MeshTally], kernel: &str) -> Measured {
    let of_it = || meshes.iter().filter(|mesh| mesh.kernel == kernel);
    let rays = of_it().map(|mesh| mesh.rays).sum();
    none_of(of_it().map(|mesh| mesh.leaks).sum(), rays)
}

fn wrong_objects(scenes: &[SceneTally]) -> Measured {
    let exact = || scenes.iter().filter(|tally| tally.model == "exact");
    let rays = exact().map(|tally| tally.rays).sum();
    none_of(exact().map(|tally| tally.wrong_ids).sum(), rays)
}

/// Instructions of exact casting and of `f64`, both with the cheaper search, which is the only one
/// whose instructions are counted.
fn instructions(scenes: &[SceneTally]) -> impl Iterator<Item = [f64; 2]> {
    let of = |model: &'static str| {
        let of_model = scenes.iter().filter(move |tally| tally.model == model);
        of_model.filter_map(|tally| tally.instructions)
    };
    of("exact").zip(of("f64")).map(|(p, q)| [p, q])
}

/// Additional instructions of exact casting.
fn added(scenes: &[SceneTally]) -> Measured {
    let [median, worst] = median_and_worst(instructions(scenes).map(|[p, q]| p - q));
    let (median, worst) = (median?, worst?);
    let is_kept = median <= 25.0 && worst <= 50.0;
    Some((format!("median {median:.0}, worst {worst:.0}"), is_kept))
}

fn ratios(all: impl Iterator<Item = f64>, is_met: fn(f64, f64) -> bool) -> Measured {
    let [median, worst] = median_and_worst(all);
    let (median, worst) = (median?, worst?);
    let measured = format!("median {median:.2}, worst {worst:.2}");
    Some((measured, is_met(median, worst)))
}
