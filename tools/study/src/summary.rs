//! The study in words: one page, and lines for a terminal.

pub mod theirs;

use std::fmt::Write;

use crate::contestants::EXACT;
use crate::judge::rule_of_three;
use crate::question::Class;
use crate::result::{Breaking, Study, Trade};

/// What was promised beside what came, for a terminal.
pub fn terminal(study: &Study) -> String {
    let mut text = String::new();
    let lengths = study.targets.iter().map(|t| t.about.chars().count());
    let width = lengths.max().unwrap_or(0);
    for target in &study.targets {
        let (mark, verdict) = match target.met {
            true => ("✓", "pass"),
            false => ("✗", "fall short"),
        };
        let padding = " ".repeat(width - target.about.chars().count());
        let (about, expected, measured) = (&target.about, &target.expected, &target.measured);
        let _ = writeln!(
            text,
            "{mark} {about}{padding}  {expected:>24}  {measured}  {verdict}"
        );
    }
    let met = study.targets.iter().filter(|target| target.met).count();
    let _ = write!(text, "{met} of {} promises are kept", study.targets.len());
    text
}

/// The page, with the plots that were drawn.
pub fn summary(study: &Study, plots: &[String]) -> String {
    let p = &study.provenance;
    let mut text = format!(
        "# Speed and accuracy, measured\n\n\
         A *kernel* is one way to compute where a ray meets a shape. All kernels are right on \
         paper, but a computer rounds. A **wrong decision** calls a hit a miss or a miss a hit. \
         An **error of t** is counted in *ulp*, steps from one number of the type to the next. The \
         judge computes with fractions and is never wrong.\n\n\
         Questions come in three classes, which are never added up. **Everyday** questions are \
         about things within a thousand sizes of each other. **Hard** ones graze, lie edge-on, \
         or look at a planet from a metre above it. **Absurd** ones have lengths beyond 1e18 or \
         below 1e-18.\n\n\
         Made by `{}` on {} ({}; {}; commit {}; seed {}; {} mode). Instructions repeat; \
         nanoseconds belong to that machine and to what else it did.\n\n",
        p.command, p.machine, p.date, p.features, p.commit, p.seed, p.mode
    );
    if theirs::is_there(study) {
        theirs::section(&mut text, study);
    }
    for shape in ["sphere", "plane", "triangle"] {
        trades(&mut text, study, shape);
    }
    tiers(&mut text, study);
    let caption = |name| match name {
        "conditioning.svg" => "Errors of t against how sensitive the question is",
        "mesh.svg" => "Rays from inside closed meshes, aimed at edges and corners",
        _ => "Wrong decisions, and the error of t",
    };
    for name in plots.iter().filter(|name| !name.starts_with("trade-")) {
        let _ = writeln!(text, "![{}]({name})\n", caption(name.as_str()));
    }
    secondary(&mut text, study);
    scenes(&mut text, study);
    plans(&mut text, study);
    choice(&mut text, study);
    table(&mut text, "Promises", "what | promised | measured | ");
    for target in &study.targets {
        let verdict = if target.met { "pass" } else { "**fall short**" };
        let (about, expected, measured) = (&target.about, &target.expected, &target.measured);
        let _ = writeln!(text, "| {about} | {expected} | {measured} | {verdict} |");
    }
    text
}

/// A heading, and the head of a table.
fn table(text: &mut String, title: &str, columns: &str) {
    let rule = "| --- ".repeat(columns.split('|').count());
    let _ = write!(text, "## {title}\n\n| {columns} |\n{rule}|\n");
}

/// A share of wrong answers; of none, what that shows.
fn share(wrong: u64, asked: u64) -> String {
    match (wrong, asked) {
        (_, 0) => "–".into(),
        (0, _) => format!("none (< {:.0e})", rule_of_three(asked)),
        _ if wrong * 10_000 < asked => format!("{wrong} of {asked}"),
        _ => format!("{:.2} %", 100.0 * wrong as f64 / asked as f64),
    }
}

fn trades(text: &mut String, study: &Study, shape: &str) {
    let all = || study.trades.iter().filter(|trade| trade.shape == shape);
    if all().next().is_none() {
        return;
    }
    let columns = "kernel | numbers | class | instructions | ns | wrong | median error of t";
    table(text, &format!("The trade: {shape}"), columns);
    for trade in all().filter(|trade| trade.asked > 0) {
        let Trade {
            kernel, numbers, ..
        } = trade;
        let cost = |cost: Option<f64>| cost.map_or("–".into(), |cost| format!("{cost:.0}"));
        let spread = trade.spread.map_or(0.0, |spread| 100.0 * spread);
        let _ = writeln!(
            text,
            "| {kernel} | {numbers} | {} | {} | {} ± {spread:.0} % | {} | {} |",
            trade.class.name(),
            cost(trade.instructions),
            cost(trade.nanoseconds),
            share(trade.wrong, trade.asked),
            trade
                .median_ulp
                .map_or("–".into(), |ulp| format!("{} ulp", short(ulp))),
        );
    }
    let _ = writeln!(
        text,
        "\n![Cost against wrong decisions: {shape}](trade-{shape}.svg)\n"
    );
}

/// Two digits or so.
pub fn short(number: f64) -> String {
    match number {
        1000.0.. => format!("{number:.0e}"),
        10.0.. => format!("{number:.0}"),
        _ => format!("{number:.2}"),
    }
}

fn tiers(text: &mut String, study: &Study) {
    if study.tiers.is_empty() {
        return;
    }
    let columns = "shape | class | tier | questions it decides | instructions | ns";
    table(text, "What an exact decision takes", columns);
    for tier in &study.tiers {
        let instructions = tier.instructions.map_or("–".into(), short);
        let _ = writeln!(
            text,
            "| {} | {} | {} | {:.2} % | {instructions} | {:.0} |",
            tier.shape,
            tier.class.name(),
            tier.tier.name(),
            100.0 * tier.decided as f64 / tier.asked as f64,
            tier.nanoseconds
        );
    }
    text.push('\n');
}

fn secondary(text: &mut String, study: &Study) {
    if study.secondary.is_empty() {
        return;
    }
    let columns = "shape | method | from the origin of the world | self-hits | lost hits";
    table(text, "Rays that begin on a surface, in f32", columns);
    for it in &study.secondary {
        let _ = writeln!(
            text,
            "| {} | {} | {} | {} | {} |",
            it.shape,
            it.method,
            it.offset,
            share(it.self_hits, it.leaving),
            share(it.lost, it.near)
        );
    }
    text.push('\n');
}

fn scenes(text: &mut String, study: &Study) {
    if study.scenes.is_empty() {
        return;
    }
    let columns = "scene | numbers | search | wrong pixels | worst t | instructions | ns | tests \
                   | past the static filter | past the semi-static one | exact";
    table(text, "Whole scenes", columns);
    for it in study
        .scenes
        .iter()
        .filter(|it| it.search.as_deref() != Some("brute force"))
    {
        let cost = |cost: Option<f64>| cost.map_or("–".into(), |cost| format!("{cost:.0}"));
        let _ = writeln!(
            text,
            "| {} | {} | {} | {} of {} | {} | {} | {} | {} | {} | {} | {} |",
            it.scene,
            it.model,
            it.search.as_deref().unwrap_or("–"),
            it.wrong_ids,
            it.rays,
            it.worst_t.map_or("–".into(), |t| format!("{t:.0e}")),
            cost(it.instructions),
            cost(it.nanoseconds),
            cost(it.tests.map(|tests| tests * it.rays as f64)),
            it.semi_static,
            it.double_double,
            it.exact + it.close_calls
        );
    }
    text.push('\n');
}

fn plans(text: &mut String, study: &Study) {
    let wishes: Vec<f64> = study.plans.iter().map(|plan| plan.accuracy).collect();
    if wishes.is_empty() {
        return;
    }
    let columns = "accuracy | worst t | worst normal | computed exactly | × exact objects | \
                   × plain f64";
    table(text, "Plans, over all scenes", columns);
    let mut seen = Vec::new();
    for wish in wishes {
        if seen.contains(&wish) {
            continue;
        }
        seen.push(wish);
        let all = || study.plans.iter().filter(|plan| plan.accuracy == wish);
        let median = |mut ratios: Vec<f64>| {
            ratios.sort_by(f64::total_cmp);
            ratios[ratios.len() / 2]
        };
        let worst_t = all().map(|plan| plan.kept.worst_t).fold(0.0, f64::max);
        let normals = all().map(|plan| plan.kept.worst_normal);
        let _ = writeln!(
            text,
            "| {wish:.0e} | {worst_t:.0e} | {:.0e} rad | {} of {} | {:.2} | {:.2} |",
            normals.fold(0.0, f64::max),
            all().map(|plan| plan.exact_hits).sum::<u64>(),
            all().map(|plan| plan.kept.rays).sum::<u64>(),
            median(
                all()
                    .map(|plan| plan.nanoseconds / plan.exact_ids)
                    .collect()
            ),
            median(all().map(|plan| plan.nanoseconds / plan.plain).collect())
        );
    }
    text.push('\n');
}

/// What to use, by what the study found.
fn choice(text: &mut String, study: &Study) {
    let cost = |shape: &str, class, kernel: &str, numbers: &str| {
        let mut trades = study.trades.iter();
        let trade = trades.find(|it| {
            (
                it.shape.as_str(),
                it.class,
                it.kernel.as_str(),
                it.numbers.as_str(),
            ) == (shape, class, kernel, numbers)
        });
        let cost = trade.and_then(|it| it.instructions.or(it.nanoseconds));
        cost.map_or("–".into(), |cost| format!("{cost:.0}"))
    };
    if study.trades.is_empty() {
        return;
    }
    table(
        text,
        "Which to use",
        "your scene is … | use … | costs, for a ray and a sphere …",
    );
    let (everyday, hard) = (Class::Everyday, Class::Hard);
    let rows = [
        (
            "everyday",
            "the textbook in f64",
            cost("sphere", everyday, "textbook", "f64"),
        ),
        (
            "hard, and a rare speck does no harm",
            "Haines et al., scaled",
            cost("sphere", hard, "Haines scaled", "f64"),
        ),
        (
            "too large for memory",
            "f32 data, f64 arithmetic",
            cost("sphere", everyday, "Haines scaled", "f64 on f32"),
        ),
        (
            "judged by its ids",
            "`pinhole render --exact`",
            cost("sphere", everyday, EXACT, "f64"),
        ),
        (
            "to have t and normals of a known accuracy",
            "`pinhole plan --accuracy X`",
            "as above, and more for X below 6e-8".into(),
        ),
    ];
    for (scene, kernel, cost) in rows {
        let _ = writeln!(text, "| {scene} | {kernel} | {cost} |");
    }
    text.push('\n');
}

/// Where a kernel breaks, in words.
fn ends(breaking: &Breaking) -> String {
    let ends = [breaking.below, breaking.above].into_iter().flatten();
    let mut ends: Vec<String> = ends.map(|x| x.to_string()).collect();
    // The easy exponent is on both sides.
    ends.dedup();
    match ends.is_empty() {
        true => "never".into(),
        false => ends.join(" and "),
    }
}
