//! The study's eight plots. In all of them, a colour stands for a kernel, and the kind of line or
//! mark for the numbers that it computes with.

mod chart;

use std::fs;
use std::path::Path;

use chart::{Axis, Look, Panel, Series, svg};

use crate::judge::Tally;
use crate::question::Class;
use crate::result::{ConditioningErrors, Findings, MeshTally, Point, Study, Sweep, Trade};

/// The families that are plotted, by shape: distant, in other units, and edge-on.
const FAMILIES: [(&str, &str); 3] = [
    ("sphere", "distance"),
    ("sphere", "scale"),
    ("triangle", "edge-on"),
];

const SHAPES: [&str; 3] = ["sphere", "plane", "triangle"];

const LINES: &str = "solid lines: f64; dashes: f32";
const MARKS: &str = "discs: f64; rings: f64 on f32 data; crosses: f32";
const ERROR: &str = "median error of t, in ulp";

/// Draws every plot that the study has data for, and returns the names of the files.
pub fn draw(study: &Study, folder: &Path) -> std::io::Result<Vec<String>> {
    let findings = &study.findings;
    let mut plots = Vec::new();
    if !findings.families.is_empty() {
        for name in FAMILIES {
            let is_it = |it: &&Sweep| (it.shape, it.family) == name;
            let both: Vec<_> = findings.families.iter().filter(is_it).collect();
            plots.push((format!("{}-{}.svg", name.0, name.1), sweep(&both)));
        }
        let trade = |shape| (format!("trade-{shape}.svg"), trade(findings, shape));
        plots.extend(SHAPES.map(trade));
    }
    if !findings.conditioning.is_empty() {
        plots.push(("conditioning.svg".into(), conditioning(findings)));
    }
    if !findings.meshes.is_empty() {
        plots.push(("mesh.svg".into(), leaks(&findings.meshes)));
    }
    for (name, svg) in &plots {
        fs::write(folder.join(name), svg)?;
    }
    Ok(plots.into_iter().map(|(name, _)| name).collect())
}

/// The distinct names in alphabetical order, so that a kernel has the same colour in all plots.
fn names<'a>(all: impl Iterator<Item = &'a str>) -> Vec<&'a str> {
    let mut names: Vec<_> = all.collect();
    names.sort_unstable();
    names.dedup();
    names
}

/// One family in both types of data: wrong decisions above, errors of t below.
fn sweep(sweeps: &[&Sweep]) -> String {
    let points = || sweeps.iter().flat_map(|sweep| &sweep.points);
    let judged = || points().flat_map(|point| &point.kernels);
    let names = names(judged().map(|judged| judged.kernel));
    let panel = |y: Axis, value: fn(&Tally) -> Option<f64>| {
        let mut series = Vec::new();
        for sweep in sweeps {
            for (kernel, name) in names.iter().enumerate() {
                let place = |point: &Point| {
                    let mut kernels = point.kernels.iter();
                    let it = kernels.find(|it| (it.kernel, it.numbers) == (*name, sweep.data))?;
                    Some((point.exponent.into(), value(&it.tally)?.log10()))
                };
                series.push(Series {
                    kernel,
                    look: Look::Line(sweep.data),
                    points: sweep.points.iter().filter_map(place).collect(),
                });
            }
        }
        Panel {
            legend: Vec::new(),
            x: Axis::exponents(sweeps[0].axis, points().map(|point| point.exponent)),
            y,
            series,
        }
    };
    let ulps = Axis::logarithmic(ERROR, judged().filter_map(|judged| judged.tally.median_ulp));
    let mut panels = [
        panel(Axis::shares("wrong decisions"), |it| Some(it.wrong_share())),
        panel(ulps, |it| it.median_ulp),
    ];
    panels[0].legend = names;
    svg(&[LINES], &panels)
}

/// Cost against wrong decisions of one shape's kernels, for each class of questions.
fn trade(findings: &Findings, shape: &str) -> String {
    let trades = || findings.trades.iter().filter(|trade| trade.shape == shape);
    let names = names(trades().map(|trade| trade.kernel));
    let is_counted = trades().any(|trade| trade.instructions.is_some());
    let (unit, cost): (_, fn(&Trade) -> Option<f64>) = match is_counted {
        true => ("instructions", |trade| trade.instructions),
        false => ("nanoseconds", |trade| trade.nanoseconds),
    };
    let unit = format!("{unit} for a ray and a shape");
    let mut panels = Class::ALL.map(|class| {
        let series = |trade: &Trade| {
            let share = trade.wrong as f64 / trade.asked as f64;
            Some(Series {
                kernel: names.iter().position(|name| *name == trade.kernel)?,
                look: Look::Mark(trade.numbers),
                points: vec![(cost(trade)?.log10(), share.log10())],
            })
        };
        let of_class = trades().filter(|trade| trade.class == class && trade.asked > 0);
        Panel {
            legend: Vec::new(),
            x: Axis::logarithmic(&unit, trades().filter_map(cost)),
            y: Axis::shares(&format!("{} questions: wrong decisions", class.name())),
            series: of_class.filter_map(series).collect(),
        }
    });
    panels[0].legend = names;
    svg(&[MARKS], &panels)
}

/// Errors of t against the question's condition number, for each shape.
fn conditioning(findings: &Findings) -> String {
    const LARGEST: i32 = 17;
    let panel = |shape: &str| {
        // The median of only a few hits means little.
        let is_shown =
            |it: &&ConditioningErrors| it.shape == shape && it.hits >= 20 && it.decade < LARGEST;
        let all = || findings.conditioning.iter().filter(is_shown);
        let names = names(all().map(|it| it.kernel));
        let half_an_ulp = |x: f64| (x, x - 2f64.log10());
        let mut series = vec![Series {
            kernel: 0,
            look: Look::Thin,
            points: [0.0, LARGEST.into()].map(half_an_ulp).into(),
        }];
        for numbers in ["f64", "f32"] {
            for (kernel, name) in names.iter().enumerate() {
                let of_it = all().filter(|it| (it.kernel, it.numbers) == (*name, numbers));
                let place =
                    |it: &ConditioningErrors| (f64::from(it.decade) + 0.5, it.median_ulp.log10());
                series.push(Series {
                    kernel,
                    look: Look::Line(numbers),
                    points: of_it.map(place).collect(),
                });
            }
        }
        Panel {
            legend: names,
            x: Axis::exponents("condition number of the question = 10^x", [0, LARGEST]),
            y: Axis::logarithmic(&format!("{shape}: {ERROR}"), all().map(|it| it.median_ulp)),
            series,
        }
    };
    let lines = format!("{LINES}; thin: what half an ulp");
    let notes = [&lines, "in each number of the question can do to t"];
    svg(&notes, &SHAPES.map(panel))
}

/// Leaks and double hits on closed meshes, for each aim.
fn leaks(meshes: &[MeshTally]) -> String {
    let names = names(meshes.iter().map(|mesh| mesh.kernel));
    let mut panels = [("edge", "edges"), ("vertex", "corners")].map(|(aim, title)| {
        let series = |mesh: &MeshTally| {
            let kernel = names.iter().position(|name| *name == mesh.kernel)?;
            let x = (kernel + 1) as f64 / (names.len() + 1) as f64;
            let share = |count: u64| (count as f64 / mesh.rays as f64).log10();
            Some(Series {
                kernel,
                look: Look::Mark(mesh.numbers),
                points: vec![(x, share(mesh.leaks)), (1.0 + x, share(mesh.double_hits))],
            })
        };
        let of_aim = meshes.iter().filter(|mesh| mesh.aimed_at == aim);
        Panel {
            legend: Vec::new(),
            x: Axis {
                name: String::new(),
                ends: (0.0, 2.0),
                label: |x| match *x {
                    0.4..0.6 => "leaks".into(),
                    1.4..1.6 => "double hits".into(),
                    _ => String::new(),
                },
            },
            y: Axis::shares(&format!("rays aimed at {title}")),
            series: of_aim.filter_map(series).collect(),
        }
    });
    panels[0].legend = names;
    svg(&[MARKS], &panels)
}
