//! The study's report: a page in Markdown, and lines for a terminal.

use std::fmt::Write;

use crate::cast::Search;
use crate::judge::{median_and_worst, rule_of_three};
use crate::result::{Findings, PlanTally, Study};

/// The promises beside the measurements, for a terminal.
pub fn terminal(study: &Study) -> String {
    let mut text = String::new();
    let lengths = study.targets.iter().map(|t| t.about.chars().count());
    let width = lengths.max().unwrap_or(0);
    for target in &study.targets {
        let (mark, verdict) = match target.met {
            true => ("✓", "pass"),
            false => ("✗", "falls short"),
        };
        let (about, expected, measured) = (&target.about, &target.expected, &target.measured);
        let _ = writeln!(
            text,
            "{mark} {about:width$}  {expected:>24}  {measured}  {verdict}"
        );
    }
    let met = study.targets.iter().filter(|target| target.met).count();
    let _ = write!(text, "{met} of {} promises are kept", study.targets.len());
    text
}

/// The Markdown page, with the plots that were drawn.
pub fn summary(study: &Study, plots: &[String]) -> String {
    let (p, findings) = (&study.provenance, &study.findings);
    let head = format!(
        "# Speed and accuracy, measured\n\n\
         A *kernel* is one way to compute where a ray meets a shape. All kernels are right on \
         paper, but a computer rounds. A **wrong decision** calls a hit a miss or a miss a hit. \
         An **error of t** is counted in *ulp*, steps from one number of the type to the next. The \
         judge computes with fractions and is never wrong.\n\n\
         Questions come in three classes, whose results are never added together. **Everyday** \
         questions are about things that are at most a thousand times their own size away. **Hard** \
         ones have grazing rays, surfaces seen edge-on, or a planet seen from a metre above it. \
         **Absurd** ones have lengths beyond 1e18 or below 1e-18.\n\n\
         Made by `{}` on {} ({}; {}; commit {}; seed {}; {} mode). Instruction \
         counts are reproducible; times in nanoseconds depend on that machine and on what else it \
         was doing.\n\n",
        p.command, p.machine, p.date, p.features, p.commit, p.seed, p.mode
    );
    let trades = ["sphere", "plane", "triangle"].map(|shape| trades(findings, shape));
    let caption = |name: &str| match name {
        "conditioning.svg" => "Error of t against the sensitivity of the question",
        "mesh.svg" => "Rays from inside closed meshes, aimed at edges and corners",
        _ => "Wrong decisions, and the error of t",
    };
    let images = plots.iter().filter(|name| !name.starts_with("trade-"));
    let promises = study.targets.iter().map(|target| {
        let verdict = if target.met {
            "pass"
        } else {
            "**falls short**"
        };
        let (expected, measured) = (&target.expected, &target.measured);
        [target.about, expected, measured, verdict].map(str::to_owned)
    });
    [
        head,
        trades.concat(),
        tiers(findings),
        images
            .map(|name| format!("![{}]({name})\n\n", caption(name)))
            .collect(),
        secondary(findings),
        scenes(findings),
        plans(findings),
        table("Promises", "what | promised | measured | ", promises),
    ]
    .concat()
    .trim_end()
    .to_owned()
        + "\n"
}

/// A section with a table; nothing if there are no rows.
fn table<const N: usize>(
    title: &str,
    columns: &str,
    rows: impl IntoIterator<Item = [String; N]>,
) -> String {
    let rows: Vec<_> = rows.into_iter().collect();
    if rows.is_empty() {
        return String::new();
    }
    let rule = "| --- ".repeat(N);
    let mut text = format!("## {title}\n\n| {columns} |\n{rule}|\n");
    for row in rows {
        let _ = writeln!(text, "| {} |", row.join(" | "));
    }
    text + "\n"
}

/// A share of wrong answers; if there are none, the upper bound that this proves.
fn share(wrong: u64, asked: u64) -> String {
    match (wrong, asked) {
        (_, 0) => "–".into(),
        (0, _) => format!("none (< {:.0e})", rule_of_three(asked)),
        _ if wrong * 10_000 < asked => format!("{wrong} of {asked}"),
        _ => format!("{:.2} %", 100.0 * wrong as f64 / asked as f64),
    }
}

/// A number, or a dash if it was not measured.
fn or_dash(number: Option<f64>, text: fn(f64) -> String) -> String {
    number.map_or("–".into(), text)
}

fn whole(number: f64) -> String {
    format!("{number:.0}")
}

/// A number with about two digits.
fn short(number: f64) -> String {
    match number {
        1000.0.. => format!("{number:.0e}"),
        10.0.. => whole(number),
        _ => format!("{number:.2}"),
    }
}

fn trades(findings: &Findings, shape: &str) -> String {
    let trades = findings.trades.iter();
    let rows = trades.filter(|trade| trade.shape == shape && trade.asked > 0);
    let columns = "kernel | numbers | class | instructions | ns | wrong | median error of t";
    let rows = rows.map(|trade| {
        let time = or_dash(trade.nanoseconds, whole);
        let spread = trade.spread.map_or(0.0, |spread| 100.0 * spread);
        [
            trade.kernel.into(),
            trade.numbers.into(),
            trade.class.name().into(),
            or_dash(trade.instructions, whole),
            format!("{time} ± {spread:.0} %"),
            share(trade.wrong, trade.asked),
            or_dash(trade.median_ulp, |ulp| format!("{} ulp", short(ulp))),
        ]
    });
    match table(&format!("The trade: {shape}"), columns, rows) {
        empty if empty.is_empty() => empty,
        text => text + &format!("![Cost against wrong decisions: {shape}](trade-{shape}.svg)\n\n"),
    }
}

fn tiers(findings: &Findings) -> String {
    let columns = "shape | class | tier | questions it decides | instructions | ns";
    let rows = findings.tiers.iter().map(|it| {
        [
            it.shape.into(),
            it.class.name().into(),
            it.tier.name().into(),
            format!("{:.2} %", 100.0 * it.decided as f64 / it.asked as f64),
            or_dash(it.instructions, short),
            whole(it.nanoseconds),
        ]
    });
    table("What an exact decision takes", columns, rows)
}

fn secondary(findings: &Findings) -> String {
    let columns = "shape | method | distance from the world's origin | self-hits | lost hits";
    let rows = findings.secondary.iter().map(|it| {
        [
            it.shape.into(),
            it.method.into(),
            it.offset.to_string(),
            share(it.self_hits, it.leaving),
            share(it.lost, it.near),
        ]
    });
    table("Rays that begin on a surface, in f32", columns, rows)
}

fn scenes(findings: &Findings) -> String {
    let scenes = findings.scenes.iter();
    let shown = scenes.filter(|it| it.search != Some(Search::BruteForce.name()));
    let columns = "scene | numbers | search | wrong pixels | worst t | instructions | ns | tests | past the static filter | past the semi-static one | exact";
    let rows = shown.map(|it| {
        [
            it.scene.clone(),
            it.model.into(),
            it.search.unwrap_or("–").into(),
            format!("{} of {}", it.wrong_ids, it.rays),
            or_dash(it.worst_t, |t| format!("{t:.0e}")),
            or_dash(it.instructions, whole),
            or_dash(it.nanoseconds, whole),
            or_dash(it.tests.map(|tests| tests * it.rays as f64), whole),
            it.semi_static.to_string(),
            it.double_double.to_string(),
            (it.exact + it.close_calls).to_string(),
        ]
    });
    table("Whole scenes", columns, rows)
}

fn plans(findings: &Findings) -> String {
    let mut wishes: Vec<f64> = findings.plans.iter().map(|plan| plan.accuracy).collect();
    wishes.sort_by(|p, q| q.total_cmp(p));
    wishes.dedup();
    let rows = wishes.into_iter().map(|wish| {
        let plans = findings.plans.iter();
        let all: Vec<&PlanTally> = plans.filter(|plan| plan.accuracy == wish).collect();
        let median = |ratio: fn(&PlanTally) -> f64| {
            let [median, _] = median_and_worst(all.iter().map(|plan| ratio(plan)));
            or_dash(median, |ratio| format!("{ratio:.2}"))
        };
        let worst = |of: fn(&PlanTally) -> f64| all.iter().map(|plan| of(plan)).fold(0.0, f64::max);
        let sum = |of: fn(&PlanTally) -> u64| all.iter().map(|plan| of(plan)).sum::<u64>();
        let rays = sum(|plan| plan.kept.rays);
        [
            format!("{wish:.0e}"),
            format!("{:.0e}", worst(|plan| plan.kept.worst_t)),
            format!("{:.0e} rad", worst(|plan| plan.kept.worst_normal)),
            format!("{} of {rays}", sum(|plan| plan.exact_hits)),
            median(|plan| plan.nanoseconds / plan.exact_ids),
            median(|plan| plan.nanoseconds / plan.plain),
        ]
    });
    let columns =
        "accuracy | worst t | worst normal | computed exactly | × exact objects | × plain f64";
    table("Plans, over all scenes", columns, rows)
}
