//! Plots errors of t against the question's condition number.

use super::paper::{Anchor, GRID, Panel, Paper, colour, curve, legend, names, ulps};
use crate::result::{ConditioningErrors, Findings};

/// Draws a panel for each shape.
pub fn svg(findings: &Findings) -> String {
    let mut paper = Paper::default();
    let note = "solid lines: f64; dashes: f32; thin: what half an ulp";
    paper.word((14.0, 14.0), Anchor::Start, note);
    let note = "in each number of the question can do to t";
    paper.word((14.0, 34.0), Anchor::Start, note);
    let mut top = 60.0;
    for shape in ["sphere", "plane", "triangle"] {
        let all = || findings.conditioning.iter().filter(|it| it.shape == shape);
        let names = names(all().map(|it| it.kernel));
        top = legend(&mut paper, top, &names) + 26.0;
        let highest = all().map(|it| it.median_ulp).fold(10.0, f64::max);
        let panel = Panel {
            top,
            bottom: top + 130.0,
            x: (0.0, 17.0),
            y: (-1.0, highest.log10().ceil()),
        };
        let title = format!("{shape}: median error of t, in ulp");
        paper.word((14.0, top - 18.0), Anchor::Start, &title);
        panel.rows(&mut paper, &ulps(panel.y.1));
        panel.columns(&mut paper, "condition number of the question", false);
        // The line κ/2 ulp reaches the panel's top before its right end.
        let end = (panel.y.1 + 0.3).min(17.0);
        let deserved = GRID.replace("0.15", "0.6");
        let ends = [panel.at(0.0, -0.3), panel.at(end, end - 0.3)];
        paper.line(&ends, &deserved);
        for numbers in ["f64", "f32"] {
            for (at, name) in names.iter().enumerate() {
                let of_it = all().filter(|it| it.kernel == *name && it.numbers == numbers);
                // The median of only a few hits means little.
                let of_it = of_it.filter(|it| it.hits >= 20 && it.decade < 17);
                let place = |it: &ConditioningErrors| {
                    panel.at(f64::from(it.decade) + 0.5, it.median_ulp.max(0.1).log10())
                };
                let points: Vec<_> = of_it.map(place).collect();
                paper.line(&points, &curve(colour(at), numbers));
            }
        }
        top = panel.bottom + 66.0;
    }
    paper.svg(top - 18.0)
}
