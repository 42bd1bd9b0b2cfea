//! Whole scenes: time against the largest error, and the front of what nobody beats.

use plotters::coord::Shift;
use plotters::prelude::*;

use super::paper::{FAINT, GROUND, INK, colour, spread, text};
use crate::result::SceneTally;

/// Of one scene's panel, and how many stand side by side.
const PANEL: (u32, u32) = (430, 250);
const COLUMNS: usize = 3;
/// Above all panels.
const HEAD: u32 = 84;
/// On the right of each, for names.
const NAMES: u32 = 165;
/// Below this all errors are drawn alike: half a unit in the last place of `f64`.
const FLOOR: f64 = -16.5;

type Paper<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// What a way computes with, a colour for each.
const NUMBERS: [&str; 4] = ["f32", "f64 on f32", "f64", "exact"];

/// A panel for every scene.
pub fn svg(scenes: &[SceneTally]) -> Result<String, String> {
    let mut panels: Vec<Vec<&SceneTally>> = Vec::new();
    for tally in scenes.iter().filter(|tally| tally.nanoseconds.is_some()) {
        match panels
            .last_mut()
            .filter(|panel| panel[0].scene == tally.scene)
        {
            Some(panel) => panel.push(tally),
            None => panels.push(vec![tally]),
        }
    }
    let rows = panels.len().div_ceil(COLUMNS) as u32;
    let size = (PANEL.0 * COLUMNS as u32, HEAD + PANEL.1 * rows);
    let mut svg = String::new();
    let backend = SVGBackend::with_string(&mut svg, size);
    draw(&panels, backend).map_err(|error| error.to_string())?;
    Ok(svg)
}

fn draw(
    panels: &[Vec<&SceneTally>],
    backend: SVGBackend,
) -> Result<(), Box<dyn std::error::Error>> {
    let paper = backend.into_drawing_area();
    paper.fill(&GROUND)?;
    let title = "Every way to cast each scene: time for a ray, and the largest error of t or of a \
                 normal";
    paper.draw(&Text::new(title, (18, 22), text(18, INK)))?;
    let note = "left is fast, low is accurate; the line joins what no other way beats, and only \
                that is named; ring: every part, disc: boxes";
    paper.draw(&Text::new(note, (18, 46), text(14, INK)))?;
    for (at, numbers) in NUMBERS.into_iter().enumerate() {
        let x = 24 + 110 * at as i32;
        paper.draw(&Circle::new((x, 68), 5, colour(at).filled()))?;
        paper.draw(&Text::new(numbers, (x + 12, 68), text(14, INK)))?;
    }
    let (_, rest) = paper.split_vertically(HEAD);
    let rows = panels.len().div_ceil(COLUMNS);
    for (panel, area) in panels.iter().zip(rest.split_evenly((rows, COLUMNS))) {
        one(panel, &area)?;
    }
    Ok(paper.present()?)
}

/// A power of ten for each axis.
fn place(tally: &SceneTally) -> (f64, f64) {
    let errors = [tally.worst_t, tally.worst_normal].into_iter().flatten();
    let error = errors.fold(0.0, f64::max);
    let time = tally.nanoseconds.unwrap_or(1.0);
    (time.log10(), error.log10().max(FLOOR))
}

/// As it is printed: 10⁻⁵.
fn power_of_ten(power: f64) -> String {
    let raised = |letter: char| match letter {
        '-' => '⁻',
        digit => ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹']
            [digit.to_digit(10).unwrap_or_default() as usize],
    };
    let power = format!("{power:.0}");
    format!("10{}", power.chars().map(raised).collect::<String>())
}

fn one(panel: &[&SceneTally], paper: &Paper) -> Result<(), Box<dyn std::error::Error>> {
    let (left, right) = panel
        .iter()
        .map(|tally| place(tally).0)
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| {
            (low.min(x), high.max(x))
        });
    let (left, right) = (left - 0.1, right + 0.1);
    paper.draw(&Text::new(
        panel[0].scene.replace('_', " "),
        (24, 12),
        text(15, INK),
    ))?;
    let mut chart = ChartBuilder::on(paper)
        .margin_left(14)
        .margin_right(NAMES)
        .margin_top(26)
        .margin_bottom(6)
        .x_label_area_size(22)
        .y_label_area_size(44)
        .build_cartesian_2d(left..right, FLOOR - 0.5..-1.0)?;
    chart
        .configure_mesh()
        .light_line_style(GROUND)
        .bold_line_style(FAINT)
        .axis_style(INK)
        .x_labels(4)
        .y_labels(6)
        .label_style(("sans-serif", 12).into_font().color(&INK))
        .x_label_formatter(&|x| match 10f64.powf(*x) {
            t if t < 1e3 => format!("{t:.0} ns"),
            t => format!("{:.1} µs", t / 1e3),
        })
        .y_label_formatter(&|y| power_of_ten(*y))
        .draw()?;
    let mut front: Vec<&SceneTally> = panel.iter().copied().filter(|t| t.on_front).collect();
    front.sort_by(|one, other| place(one).0.total_cmp(&place(other).0));
    let line = front.iter().map(|tally| place(tally));
    chart.draw_series(LineSeries::new(line, INK.stroke_width(1)))?;
    let of = |tally: &SceneTally| {
        let at = NUMBERS.iter().position(|numbers| *numbers == tally.model);
        colour(at.unwrap_or_default())
    };
    for tally in panel {
        let (at, colour) = (place(tally), of(tally));
        match tally.search.as_deref() {
            Some("boxes") => chart.draw_series([Circle::new(at, 4, colour.filled())])?,
            _ => chart.draw_series([Circle::new(at, 4, colour.stroke_width(2))])?,
        };
    }
    let shift = paper.get_base_pixel();
    let edge = chart.backend_coord(&(right, FLOOR)).0 - shift.0 + 10;
    let mut names: Vec<_> = front
        .iter()
        .map(|tally| (chart.backend_coord(&place(tally)), tally))
        .map(|((x, y), tally)| ((x - shift.0, y - shift.1), tally))
        .map(|(from, tally)| (f64::from(from.1) - 7.5, 15.0, (from, tally)))
        .collect();
    spread(&mut names, 26.0, f64::from(PANEL.1) - 28.0);
    for (y, _, (from, tally)) in names {
        let (y, colour) = (y as i32 + 7, of(tally));
        paper.draw(&PathElement::new([from, (edge, y)], colour.mix(0.4)))?;
        let wrong = match tally.wrong_ids {
            0 => String::new(),
            wrong => format!(", {wrong} wrong"),
        };
        let name = format!(
            "{} {}{wrong}",
            tally.model,
            tally.kernels.as_deref().unwrap_or("")
        );
        paper.draw(&Text::new(name, (edge + 4, y), text(12, colour)))?;
    }
    Ok(())
}
