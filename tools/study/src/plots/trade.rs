//! Plots cost against wrong decisions, with a panel for each class of questions.

use super::paper::{Anchor, Panel, Paper, Shares, colour, legend, names};
use crate::question::Class;
use crate::result::{Findings, Trade};

/// Draws the three panels of one shape.
pub fn svg(findings: &Findings, shape: &str) -> String {
    let trades = || findings.trades.iter().filter(|trade| trade.shape == shape);
    let names = names(trades().map(|trade| trade.kernel));
    let mut paper = Paper::default();
    let next = legend(&mut paper, 14.0, &names);
    paper.dot((20.0, next), 6.0, "currentColor", true);
    paper.word((32.0, next), Anchor::Start, "f64");
    paper.dot((92.0, next), 6.0, "currentColor", false);
    paper.word((104.0, next), Anchor::Start, "f64 on f32 data");
    paper.cross((250.0, next), 5.0, "currentColor");
    paper.word((262.0, next), Anchor::Start, "f32");

    let is_counted = trades().any(|trade| trade.instructions.is_some());
    let (what, cost): (_, fn(&Trade) -> Option<f64>) = match is_counted {
        true => ("instructions for a ray and a shape", |trade| {
            trade.instructions
        }),
        false => ("nanoseconds for a ray and a shape", |trade| {
            trade.nanoseconds
        }),
    };
    let costs = || trades().filter_map(cost);
    let least = costs().fold(f64::INFINITY, f64::min).log10() - 0.1;
    let most = costs().fold(1.0, f64::max).log10() + 0.1;
    let shares = Shares::of(trades().map(|trade| trade.asked).max().unwrap_or(1));
    let mut top = next + 46.0;
    for class in Class::ALL {
        let panel = Panel {
            top,
            bottom: top + 116.0,
            x: (least, most),
            y: shares.y,
        };
        let title = format!("{} questions: wrong decisions", class.name());
        paper.word((14.0, top - 18.0), Anchor::Start, &title);
        panel.rows(&mut paper, &shares.ticks());
        let meaning = if class == Class::Absurd { what } else { "" };
        panel.columns(&mut paper, meaning, false);
        for trade in trades().filter(|trade| trade.class == class && trade.asked > 0) {
            let Some(cost) = cost(trade) else { continue };
            let place = names.iter().position(|name| *name == trade.kernel);
            let colour = colour(place.unwrap_or_default());
            let at = panel.at(cost.log10(), shares.at(trade.wrong, trade.asked));
            match trade.numbers {
                "f64" => paper.dot(at, 6.0, colour, true),
                "f32" => paper.cross(at, 5.0, colour),
                _ => paper.dot(at, 6.0, colour, false),
            }
        }
        top = panel.bottom + 66.0;
    }
    paper.svg(top - 20.0)
}
