//! The study in words: a page for the book, and lines for a terminal.

mod plans;
mod scenes;
pub mod theirs;

use std::fmt::Write;

use crate::judge::rule_of_three;
use crate::result::{Breaking, Speed, Study};

/// What was expected beside what came, for a terminal.
pub fn terminal(study: &Study) -> String {
    let mut text = String::new();
    let width = study
        .targets
        .iter()
        .map(|t| t.about.chars().count())
        .max()
        .unwrap_or(0);
    for target in &study.targets {
        let mark = if target.met { "✓" } else { "✗" };
        let verdict = if target.met { "pass" } else { "fall short" };
        let padding = " ".repeat(width - target.about.chars().count());
        let (about, expected, measured) = (&target.about, &target.expected, &target.measured);
        let _ = writeln!(
            text,
            "{mark} {about}{padding}  {expected:>14}  {measured}  {verdict}"
        );
    }
    let met = study.targets.iter().filter(|target| target.met).count();
    let _ = write!(
        text,
        "{met} of {} figures agree with what was measured before, or was promised",
        study.targets.len()
    );
    text
}

/// The page, with the plots that were drawn.
pub fn summary(study: &Study, plots: &[String]) -> String {
    let mut text = String::new();
    let p = &study.provenance;
    let _ = write!(
        text,
        "# Speed and accuracy, measured\n\n\
         A *kernel* is one way to compute where a ray meets a shape. All are right on paper. A \
         computer keeps 53 binary digits of a number (`f64`) or 24 (`f32`) and rounds the rest \
         away; here is what that does to each kernel, and what a better one costs.\n\n\
         An answer can go wrong in two ways. A **wrong decision** says hit where the ray misses, \
         or miss where it hits: a hole or a speck in the picture. An **inaccurate t** puts the \
         hit at a wrong distance; we count it in *ulp*, steps from one number of the type to the \
         next: ½ is perfect, 10 loses the last decimal digit, 1e8 half of all digits of an \
         `f64`. The judge computes with fractions and is never wrong.\n\n\
         Made by `{}` on {} ({}; {}; commit {}; seed {}; {} mode).\n\n",
        p.command, p.machine, p.date, p.features, p.commit, p.seed, p.mode
    );
    if theirs::is_there(study) {
        theirs::section(&mut text, study);
    }
    costs(&mut text, &study.speed, &study.breaking);
    if !study.meshes.is_empty() {
        meshes(&mut text, study);
    }
    if !study.scenes.is_empty() {
        scenes::section(&mut text, study, plots);
    }
    plans::section(&mut text, study);
    sweeps(&mut text, study, plots);
    if !study.spoilt.is_empty() {
        spoilt(&mut text, study);
    }
    let _ = write!(
        text,
        "## Measured before or promised, and now\n\n| what | before | now | |\n| --- | --- | --- | --- |\n"
    );
    for target in &study.targets {
        let verdict = if target.met { "pass" } else { "**fall short**" };
        let _ = writeln!(
            text,
            "| {} | {} | {} | {verdict} |",
            target.about, target.expected, target.measured
        );
    }
    text
}

/// Wrong decisions of one kernel over all families, and questions.
pub fn wrong_in_all(breaking: &[Breaking], speed: &Speed) -> (u64, u64) {
    let of_it = breaking.iter().filter(|b| {
        b.shape == speed.shape && b.kernel == speed.kernel && b.numbers == speed.numbers
    });
    of_it.fold((0, 0), |sum, b| (sum.0 + b.wrong, sum.1 + b.asked))
}

fn costs(text: &mut String, speeds: &[Speed], breaking: &[Breaking]) {
    if speeds.is_empty() {
        return;
    }
    let _ = write!(
        text,
        "## What each costs, and buys\n\n\
         *Cost* is time relative to the fastest kernel on the same data; *wrong* counts wrong \
         decisions over all families of questions below, most of which are cruel. Where none is \
         wrong, the true share is below the number in brackets with 95 % confidence.\n\n"
    );
    for shape in ["sphere", "plane", "triangle"] {
        if speeds.iter().any(|speed| speed.shape == shape) {
            let _ = writeln!(
                text,
                "![Cost against wrong decisions: {shape}](trade-{shape}.svg)\n"
            );
        }
    }
    let _ = write!(
        text,
        "| shape | kernel | numbers | cost | ns | instructions | wrong |\n\
         | --- | --- | --- | --- | --- | --- | --- |\n"
    );
    for speed in speeds {
        let (wrong, asked) = wrong_in_all(breaking, speed);
        let wrong = match (wrong, asked) {
            (_, 0) => "–".into(),
            (0, _) => format!("0 of {asked} (< {:.0e})", rule_of_three(asked)),
            _ => format!("{:.2} %", 100.0 * wrong as f64 / asked as f64),
        };
        let instructions = speed
            .instructions
            .map_or("–".into(), |count| format!("{count:.0}"));
        let Speed {
            shape,
            kernel,
            numbers,
            ratio,
            nanoseconds,
            ..
        } = speed;
        let _ = writeln!(
            text,
            "| {shape} | {kernel} | {numbers} | {ratio:.2} | {nanoseconds:.1} | {instructions} | {wrong} |"
        );
    }
    text.push('\n');
}

fn meshes(text: &mut String, study: &Study) {
    let _ = write!(
        text,
        "## Closed meshes\n\n\
         From inside a closed mesh every ray meets the surface exactly once. A *leak* is a ray \
         that meets nothing, and shows as a hole; a *double hit* meets two triangles, and shows \
         where hits are counted. These rays are aimed at edges and corners on purpose.\n\n\
         ![Leaks and double hits](mesh.svg)\n\n\
         | kernel | numbers | aimed at | rays | leaks | double hits |\n\
         | --- | --- | --- | --- | --- | --- |\n"
    );
    for mesh in &study.meshes {
        let share = |count: u64| match count {
            0 => format!("0 (< {:.0e})", rule_of_three(mesh.rays)),
            _ => format!("{:.2} %", 100.0 * count as f64 / mesh.rays as f64),
        };
        let _ = writeln!(
            text,
            "| {} | {} | {} | {} | {} | {} |",
            mesh.kernel,
            mesh.numbers,
            mesh.aimed_at,
            mesh.rays,
            share(mesh.leaks),
            share(mesh.double_hits)
        );
    }
    text.push('\n');
}

fn sweeps(text: &mut String, study: &Study, plots: &[String]) {
    let _ = write!(
        text,
        "## The extremes\n\n\
         Each plot asks the same question harder and harder, from left to right. Above: the share \
         of wrong decisions; a line on the floor is never wrong. Below: the median error of t. \
         *Breaks at* is where more than one decision in a thousand is wrong, a t is not finite, \
         or half of all t have lost half of their digits. *Silent* counts faults that only a \
         number too large or too small for its type explains, and that nothing in the answer \
         shows.\n\n"
    );
    for sweep in &study.families {
        let name = format!("{}-{}-{}.svg", sweep.shape, sweep.family, sweep.data);
        let _ = writeln!(
            text,
            "### {}, {}, {}\n\n{}; x: {}.\n",
            sweep.shape,
            sweep.family,
            sweep.data,
            sentence(&sweep.meaning),
            sweep.axis
        );
        if plots.contains(&name) {
            let _ = writeln!(text, "![{}, {}](<{name}>)\n", sweep.shape, sweep.family);
        }
        let _ = write!(
            text,
            "| kernel | numbers | breaks at x | wrong | silent | largest median error |\n| --- | --- | --- | --- | --- | --- |\n"
        );
        let is_of_sweep = |b: &&Breaking| {
            let data = if b.numbers == "f64" { "f64" } else { "f32" };
            b.shape == sweep.shape && b.family == sweep.family && data == sweep.data
        };
        for b in study.breaking.iter().filter(is_of_sweep) {
            let ends = ends(b);
            let wrong = match b.wrong {
                0 => format!("0 of {} (< {:.0e})", b.asked, rule_of_three(b.asked)),
                wrong => format!("{wrong} of {}", b.asked),
            };
            let ulp = b
                .worst_median_ulp
                .map_or("–".into(), |ulp| format!("{ulp:.2}"));
            let ulp = if ulp.len() > 7 {
                format!("{:.0e}", b.worst_median_ulp.unwrap_or(0.0))
            } else {
                ulp
            };
            let _ = writeln!(
                text,
                "| {} | {} | {ends} | {wrong} | {} | {ulp} ulp |",
                b.kernel, b.numbers, b.silent
            );
        }
        text.push('\n');
    }
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

fn sentence(text: &str) -> String {
    let mut letters = text.chars();
    letters
        .next()
        .map(|first| first.to_uppercase().chain(letters).collect())
        .unwrap_or_default()
}

fn spoilt(text: &mut String, study: &Study) {
    let _ = write!(
        text,
        "## Inputs that are no ordinary numbers\n\n\
         One number of shape, ray or min_t is replaced, each in turn. No kernel may answer with \
         a hit where an input is NaN or infinite; where all are finite, the judge knows better.\n\n\
         | shape | kernel | numbers | replaced by | questions | hits of nothing | wrong | not finite |\n\
         | --- | --- | --- | --- | --- | --- | --- | --- |\n"
    );
    for s in study
        .spoilt
        .iter()
        .filter(|s| s.hits_of_nothing + s.wrong + s.not_finite > 0)
    {
        let _ = writeln!(
            text,
            "| {} | {} | {} | {} | {} | {} | {} | {} |",
            s.shape,
            s.kernel,
            s.numbers,
            s.spoiler,
            s.asked,
            s.hits_of_nothing,
            s.wrong,
            s.not_finite
        );
    }
    let faultless = study
        .spoilt
        .iter()
        .filter(|s| s.hits_of_nothing + s.wrong + s.not_finite == 0);
    let _ = write!(
        text,
        "\nThe other {} combinations are without fault.\n\n",
        faultless.count()
    );
}
