//! Plots a sweep: wrong decisions above, errors of t below, solid lines for `f64` and dashed
//! lines for `f32`.

use super::paper::{Anchor, Panel, Paper, Shares, colour, curve, legend, names, ulps};
use crate::judge::Tally;
use crate::result::{Point, Sweep};

/// Draws one family, in both types of data.
pub fn svg(sweeps: &[&Sweep]) -> String {
    let points = || sweeps.iter().flat_map(|sweep| &sweep.points);
    let judged = || points().flat_map(|point| &point.kernels);
    let names = names(judged().map(|judged| judged.kernel));
    let mut paper = Paper::default();
    let next = legend(&mut paper, 14.0, &names);
    let note = "solid lines: f64; dashes: f32";
    paper.word((20.0, next), Anchor::Start, note);

    let exponents = || points().map(|point| f64::from(point.exponent));
    let x = (
        exponents().fold(f64::MAX, f64::min),
        exponents().fold(f64::MIN, f64::max),
    );
    let shares = Shares::of(judged().map(|judged| judged.tally.asked).max().unwrap_or(1));
    let highest = judged()
        .filter_map(|judged| judged.tally.median_ulp)
        .fold(10.0, f64::max);
    let above = Panel {
        top: next + 44.0,
        bottom: next + 214.0,
        x,
        y: shares.y,
    };
    paper.word((14.0, above.top - 18.0), Anchor::Start, "wrong decisions");
    above.rows(&mut paper, &shares.ticks());
    let (meaning, of_a_tenth) = match sweeps[0].axis.split_once(" = 10^−x") {
        Some((name, unit)) => (format!("{name}{}", unit_of(unit)), true),
        None => (sweeps[0].axis.replace(" = 10^x", ""), false),
    };
    above.columns(&mut paper, "", of_a_tenth);
    let share = |tally: &Tally| Some(shares.at(tally.wrong(), tally.asked));
    lines(&mut paper, &above, sweeps, &names, &share);

    let below = Panel {
        top: above.bottom + 62.0,
        bottom: above.bottom + 212.0,
        x,
        y: (-1.0, highest.log10().ceil()),
    };
    let title = "median error of t, in ulp";
    paper.word((14.0, below.top - 18.0), Anchor::Start, title);
    below.rows(&mut paper, &ulps(below.y.1));
    below.columns(&mut paper, &meaning, of_a_tenth);
    let error = |tally: &Tally| tally.median_ulp.map(|ulp| ulp.max(0.1).log10());
    lines(&mut paper, &below, sweeps, &names, &error);
    paper.svg(below.bottom + 48.0)
}

/// Turns the unit " radii" into ", in radii".
fn unit_of(rest: &str) -> String {
    match rest.trim() {
        "" => String::new(),
        "of it" => ", divided by it".into(),
        unit => format!(", in {unit}"),
    }
}

fn lines(
    paper: &mut Paper,
    panel: &Panel,
    sweeps: &[&Sweep],
    names: &[&str],
    value: &dyn Fn(&Tally) -> Option<f64>,
) {
    for (sweep, (at, name)) in sweeps
        .iter()
        .flat_map(|sweep| names.iter().enumerate().map(move |name| (sweep, name)))
    {
        let of_kernel = |point: &Point| {
            let mut kernels = point.kernels.iter();
            let judged = kernels.find(|it| it.kernel == *name && it.numbers == sweep.data)?;
            Some(panel.at(f64::from(point.exponent), value(&judged.tally)?))
        };
        let points: Vec<_> = sweep.points.iter().filter_map(of_kernel).collect();
        paper.line(&points, &curve(colour(at), sweep.data));
    }
}
