//! The promises: what each is about, what was promised, and what a run found.

use crate::contestants::EXACT;
use crate::embree;
use crate::judge::{median_and_worst, rule_of_three};
use crate::question::Class;
use crate::result::{EmbreeTally, Findings, PlanTally, SceneTally, Target, Trade};

/// Numerically careful kernels without exact decisions.
const CAREFUL: [&str; 3] = ["Haines scaled", "shifted origin", "Woop, edges owned"];

/// Compares every promise that the run has findings for.
pub fn targets(findings: &Findings) -> Vec<Target> {
    let decisions = |class: Class, is_it: fn(&Trade) -> bool| {
        let of_class = findings.trades.iter().filter(|it| it.class == class);
        sum(of_class.filter(|it| is_it(it)), |it| {
            [it.wrong + it.not_finite, it.asked]
        })
    };
    let exact = Class::ALL.map(|class| {
        let about = format!("exact kernels: wrong decisions, {}", class.name());
        never(&about, decisions(class, |it| it.kernel == EXACT))
    });
    let careful = decisions(Class::Everyday, |it| {
        it.numbers == "f64 on f32" && CAREFUL.contains(&it.kernel)
    });
    let leaks = |kernel: &str| {
        let meshes = findings.meshes.iter().filter(|it| it.kernel == kernel);
        sum(meshes, |it| [it.leaks, it.rays])
    };
    let objects = |scenes: &[SceneTally]| {
        let exact = scenes.iter().filter(|it| it.model == "exact");
        sum(exact, |it| [it.errors.wrong_ids, it.errors.rays])
    };
    let plans =
        |wrong: fn(&PlanTally) -> u64| sum(findings.plans.iter(), |it| [wrong(it), it.kept.rays]);
    let ratio = |of: fn(&PlanTally) -> f64| median_and_worst(findings.plans.iter().map(of));
    let any = f64::INFINITY;
    let all = [
        never(
            "f64 on f32 data, careful kernels: wrong decisions, everyday",
            careful,
        ),
        error_of_t(findings),
        never("exact triangles: leaks at edges and corners", leaks(EXACT)),
        never(
            "Woop, edges owned: leaks at edges and corners",
            leaks(CAREFUL[2]),
        ),
        never(
            "exact casting: wrong objects in the scenes",
            objects(&findings.scenes),
        ),
        never(
            "exact casting: wrong objects on grids",
            objects(&findings.grids),
        ),
        never(
            "plans: pixels less accurate than requested",
            plans(|it| it.kept.violations),
        ),
        never(
            "plans: pixels with a wrong object",
            plans(|it| it.kept.wrong_ids),
        ),
        never(
            "plans of random scenes: plans that break their promise",
            sum(findings.random_plans.iter(), |it| {
                [it.broken.len() as u64, it.plans]
            }),
        ),
        cost(
            "exact casting: extra instructions per ray, compared with f64",
            [25.0, 50.0],
            median_and_worst(instructions(&findings.scenes).map(|[p, q]| p - q)),
            0,
        ),
        cost(
            "exact casting on grids: instructions ÷ instructions in f64",
            [any, 3.0],
            median_and_worst(instructions(&findings.grids).map(|[p, q]| p / q)),
            2,
        ),
        cost(
            "exact casting of meshes: time ÷ Embree's time",
            [any, 1.5],
            median_and_worst(exact_beside_embree(findings).map(|it| it.over_embree)),
            2,
        ),
        agreement(findings),
        cost(
            "plans: time ÷ time with exact objects only",
            [any, 1.0],
            ratio(|it| it.nanoseconds / it.exact_ids),
            2,
        ),
        cost(
            "plans: time ÷ time in plain f64",
            [1.0, any],
            ratio(|it| it.nanoseconds / it.plain),
            2,
        ),
        cost(
            "planning: time ÷ time to build a tree and render a film in plain f64",
            [any, 1.0],
            ratio(|it| it.planning / (it.plain_tree + it.plain)),
            2,
        ),
    ];
    exact.into_iter().chain(all).flatten().collect()
}

/// Adds up wrong answers and questions.
fn sum<T>(all: impl Iterator<Item = T>, counts: impl Fn(T) -> [u64; 2]) -> [u64; 2] {
    all.map(counts)
        .fold([0; 2], |[wrong, asked], [w, a]| [wrong + w, asked + a])
}

fn never(about: &str, [wrong, asked]: [u64; 2]) -> Option<Target> {
    let bound = match wrong {
        0 => format!(" (below {:.1e} with 95 % confidence)", rule_of_three(asked)),
        _ => String::new(),
    };
    (asked > 0).then(|| Target {
        about: about.into(),
        expected: "0".into(),
        measured: format!("{wrong} of {asked}{bound}"),
        met: wrong == 0,
        is_time: false,
    })
}

fn error_of_t(findings: &Findings) -> Option<Target> {
    let all = findings.conditioning.iter();
    let exact = all.filter(|it| (it.kernel, it.numbers) == (EXACT, "f64"));
    let worst = exact.map(|it| it.worst_ulp).reduce(f64::max)?;
    Some(Target {
        about: "exact kernels: largest error of t, f64".into(),
        expected: "≤ 1e8 ulp".into(),
        measured: format!("{worst:.1e} ulp"),
        met: worst <= 1e8,
        is_time: false,
    })
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

fn exact_beside_embree(findings: &Findings) -> impl Iterator<Item = &EmbreeTally> {
    let all = findings.embree.iter();
    all.filter(|it| it.caster == embree::EXACT)
}

/// Embree rounds to `f32`, so it may be wrong about a few rays that pass close to an edge.
fn agreement(findings: &Findings) -> Option<Target> {
    let others = findings.embree.iter();
    let others = others.filter(|it| it.caster != embree::EXACT);
    let [differ, rays] = sum(others, |it| [it.differ, it.rays]);
    (rays > 0).then(|| Target {
        about: "exact casting of meshes: hits that Embree and plain f64 do not see".into(),
        expected: "≤ 1 of 10000".into(),
        measured: format!("{differ} of {rays}"),
        met: differ * 10_000 <= rays,
        is_time: false,
    })
}

/// A promise about the median and the largest of some costs.
fn cost(
    about: &str,
    limits: [f64; 2],
    [median, worst]: [Option<f64>; 2],
    digits: usize,
) -> Option<Target> {
    let (median, worst) = (median?, worst?);
    let limited = ["median", "worst"].into_iter().zip(limits);
    let limited = limited.filter(|(_, limit)| limit.is_finite());
    let expected: Vec<_> = limited
        .map(|(name, limit)| format!("{name} ≤ {limit:.digits$}"))
        .collect();
    Some(Target {
        about: about.into(),
        expected: expected.join(", "),
        measured: format!("median {median:.digits$}, worst {worst:.digits$}"),
        met: median <= limits[0] && worst <= limits[1],
        is_time: true,
    })
}
