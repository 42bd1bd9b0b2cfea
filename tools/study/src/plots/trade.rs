//! Cost against wrong decisions: the trade itself.

use plotters::prelude::*;

use super::paper::{FAINT, GROUND, INK, colour, spread, text};
use crate::result::{Speed, Study};
use crate::summary::wrong_in_all;

const SIZE: (u32, u32) = (860, 460);

/// A point for every kernel of a shape.
pub fn svg(study: &Study, shape: &str) -> Result<String, String> {
    let mut svg = String::new();
    draw(study, shape, SVGBackend::with_string(&mut svg, SIZE))
        .map_err(|error| error.to_string())?;
    Ok(svg)
}

fn draw(study: &Study, shape: &str, backend: SVGBackend) -> Result<(), Box<dyn std::error::Error>> {
    let paper = backend.into_drawing_area();
    paper.fill(&GROUND)?;
    let title =
        format!("{shape}: what a kernel costs, and how often it decides wrongly over all extremes");
    paper.draw(&Text::new(title, (18, 22), text(17, INK)))?;
    let note =
        "left is fast, low is right; filled: f64, hollow: f64 arithmetic on f32 data, cross: f32";
    paper.draw(&Text::new(note, (18, 46), text(14, INK)))?;
    let speeds: Vec<&Speed> = study
        .speed
        .iter()
        .filter(|speed| speed.shape == shape)
        .collect();
    let fastest = speeds
        .iter()
        .map(|s| s.nanoseconds)
        .fold(f64::MAX, f64::min);
    let slowest = speeds.iter().map(|s| s.nanoseconds).fold(0.0, f64::max);
    let most = speeds
        .iter()
        .map(|speed| wrong_in_all(&study.breaking, speed).1)
        .max()
        .unwrap_or(1);
    let floor = -(most.max(10) as f64).log10() - 0.3;
    let (left, right) = ((fastest * 0.85).log10(), (slowest * 1.2).log10());
    let mut chart = ChartBuilder::on(&paper)
        .margin_left(18)
        .margin_right(210)
        .margin_top(66)
        .x_label_area_size(46)
        .y_label_area_size(80)
        .build_cartesian_2d(left..right, floor..0.2)?;
    chart
        .configure_mesh()
        .light_line_style(GROUND)
        .bold_line_style(FAINT)
        .axis_style(INK)
        .y_labels(6)
        .x_labels(8)
        .x_desc("nanoseconds for a ray and a shape")
        .label_style(("sans-serif", 13).into_font().color(&INK))
        .x_label_formatter(&|x| format!("{:.0}", 10f64.powf(*x)))
        .y_label_formatter(&|y| match *y {
            y if y < floor + 0.6 => "none".into(),
            y if y < -3.5 => format!("1 in 10^{:.0}", -y),
            y => format!("{} %", 10f64.powf(y + 2.0)),
        })
        .draw()?;
    let mut labels = Vec::new();
    let mut names: Vec<&str> = Vec::new();
    for speed in &speeds {
        if !names.contains(&speed.kernel.as_str()) {
            names.push(&speed.kernel);
        }
        let (wrong, asked) = wrong_in_all(&study.breaking, speed);
        let share = (wrong as f64 / asked.max(1) as f64).log10().max(floor);
        let at = (speed.nanoseconds.log10(), share);
        let kernel = names
            .iter()
            .position(|name| *name == speed.kernel)
            .unwrap_or_default();
        let colour = colour(kernel);
        let hollow = colour.stroke_width(2);
        if speed.numbers == "f64" {
            chart.draw_series([Circle::new(at, 6, colour.filled())])?;
            labels.push((at, kernel));
        } else if speed.numbers == "f32" {
            chart.draw_series([Cross::new(at, 5, hollow)])?;
        } else {
            chart.draw_series([Circle::new(at, 5, hollow)])?;
        }
    }
    let edge = chart.backend_coord(&(right, floor)).0 + 14;
    let mut labels: Vec<_> = labels
        .into_iter()
        .map(|(at, kernel)| (chart.backend_coord(&at), kernel))
        .map(|(from, kernel)| (f64::from(from.1) - 9.0, 18.0, (from, kernel)))
        .collect();
    spread(&mut labels, 70.0, 410.0);
    for (y, _, (from, kernel)) in labels {
        let (y, colour) = (y as i32 + 9, colour(kernel));
        paper.draw(&PathElement::new([from, (edge, y)], colour.mix(0.4)))?;
        paper.draw(&Text::new(
            names[kernel].to_owned(),
            (edge + 4, y),
            text(13, colour),
        ))?;
    }
    Ok(paper.present()?)
}
