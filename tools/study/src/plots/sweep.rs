//! A sweep: wrong decisions above, errors of t below.

use plotters::coord::Shift;
use plotters::prelude::*;

use super::paper::{FAINT, GROUND, INK, colour, spread, text};
use crate::judge::Tally;
use crate::result::{Point, Sweep};
use crate::theirs;

const SIZE: (u32, u32) = (900, 640);
/// Room on the right for labels.
const LABELS: u32 = 300;
/// Height of a row of them.
const ROW: f64 = 14.0;

/// Lines nowhere further apart than this power of ten are drawn as one.
const NEAR: f64 = 0.3;

type Paper<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// Lines that lie on each other share one label.
struct Line {
    names: Vec<String>,
    colour: RGBColor,
    /// Of the stroke: a student's line shows through all others.
    width: u32,
    values: Vec<(f64, f64)>,
}

impl Line {
    /// Its label, two names on each row.
    fn rows(&self) -> Vec<String> {
        self.names.chunks(2).map(|names| names.join(", ")).collect()
    }
}

/// What is plotted, on a scale of powers of ten with a floor for 0.
struct Panel {
    title: &'static str,
    value: fn(&Tally) -> Option<f64>,
    floor: f64,
    top: f64,
    tick: fn(f64) -> String,
}

/// The picture of one sweep.
pub fn svg(sweep: &Sweep) -> Result<String, String> {
    let mut svg = String::new();
    draw(sweep, SVGBackend::with_string(&mut svg, SIZE)).map_err(|error| error.to_string())?;
    Ok(svg)
}

fn draw(sweep: &Sweep, backend: SVGBackend) -> Result<(), Box<dyn std::error::Error>> {
    let paper = backend.into_drawing_area();
    paper.fill(&GROUND)?;
    let asked = sweep
        .points
        .iter()
        .flat_map(|p| &p.kernels)
        .map(|k| k.tally.asked)
        .max()
        .unwrap_or(1);
    let title = format!("{} in {}: {}", sweep.shape, sweep.data, sweep.meaning);
    paper.draw(&Text::new(title, (18, 22), text(17, INK)))?;
    let note = format!("x: {};  {asked} questions at each x", sweep.axis);
    paper.draw(&Text::new(note, (18, 46), text(14, INK)))?;
    let (_, rest) = paper.split_vertically(60);
    let (above, below) = rest.split_vertically(290);
    let share = Panel {
        title: "wrong decisions",
        value: |tally| Some(tally.wrong_share()),
        floor: -((asked as f64).log10().ceil()) - 0.5,
        top: 0.0,
        tick: |power| match power {
            ..-3.5 => format!("1 in 10^{:.0}", -power),
            _ => format!("{} %", 10f64.powf(power + 2.0)),
        },
    };
    panel(&above, sweep, &share, "none")?;
    let error = Panel {
        title: "median error of t",
        value: |tally| tally.median_ulp,
        floor: -1.5,
        top: 17.0,
        tick: |power| match power {
            0.0 => "1 ulp".into(),
            _ => format!("10^{power:.0} ulp"),
        },
    };
    panel(&below, sweep, &error, "≤ 0.03 ulp")?;
    Ok(paper.present()?)
}

fn panel(
    paper: &Paper,
    sweep: &Sweep,
    panel: &Panel,
    none: &str,
) -> Result<(), Box<dyn std::error::Error>> {
    let lines = lines(sweep, panel);
    let (first, last) = (
        f64::from(sweep.points[0].exponent),
        f64::from(sweep.points[sweep.points.len() - 1].exponent),
    );
    let highest = lines
        .iter()
        .flat_map(|line| &line.values)
        .map(|value| value.1)
        .fold(1.0, f64::max);
    let top = if panel.top == 0.0 {
        0.2
    } else {
        (highest + 1.0).min(panel.top)
    };
    let mut chart = ChartBuilder::on(paper)
        .margin_left(18)
        .margin_right(LABELS)
        .margin_top(30)
        .x_label_area_size(28)
        .y_label_area_size(80)
        .build_cartesian_2d(first..last, panel.floor..top)?;
    paper.draw(&Text::new(panel.title, (18, 14), text(15, INK)))?;
    let floor = panel.floor;
    chart
        .configure_mesh()
        .light_line_style(GROUND)
        .bold_line_style(FAINT)
        .axis_style(INK)
        .x_labels(10)
        .y_labels(6)
        .label_style(("sans-serif", 13).into_font().color(&INK))
        .x_label_formatter(&|x| format!("{x:.0}"))
        .y_label_formatter(&|y| {
            if *y <= floor + 0.4 {
                none.into()
            } else {
                (panel.tick)(*y)
            }
        })
        .draw()?;
    for line in &lines {
        chart.draw_series(LineSeries::new(
            line.values.clone(),
            line.colour.stroke_width(line.width),
        ))?;
        chart.draw_series(
            line.values
                .iter()
                .map(|at| Circle::new(*at, 3, line.colour.filled())),
        )?;
    }
    let end = |line: &Line| line.values.last().copied().unwrap_or((last, floor));
    let mut labels: Vec<(f64, f64, &Line)> = lines
        .iter()
        .map(|line| (f64::from(chart.backend_coord(&end(line)).1) - 7.0, line))
        .map(|(place, line)| (place, ROW * line.rows().len() as f64 + 3.0, line))
        .collect();
    let (edge, low) = chart.backend_coord(&(last, floor));
    let high = chart.backend_coord(&(last, top)).1;
    spread(&mut labels, f64::from(high) - 20.0, f64::from(low) + 30.0);
    // Backend coordinates are the whole picture's; this panel's begin where it lies.
    let shift = paper.get_base_pixel();
    let corner = edge - shift.0 + 14;
    for (place, _, line) in labels {
        let (x, from) = chart.backend_coord(&end(line));
        let (x, from) = (x - shift.0, from - shift.1);
        for (row, words) in line.rows().into_iter().enumerate() {
            let y = (place + 7.0 + ROW * row as f64) as i32 - shift.1;
            if row == 0 {
                paper.draw(&PathElement::new([(x, from), (corner, y)], line.colour))?;
            }
            paper.draw(&Text::new(words, (corner + 4, y), text(12, line.colour)))?;
        }
    }
    Ok(())
}

fn lines(sweep: &Sweep, panel: &Panel) -> Vec<Line> {
    let mut lines: Vec<Line> = Vec::new();
    let mut kernels: Vec<&str> = Vec::new();
    for (at, kernel) in sweep.points[0].kernels.iter().enumerate() {
        let value = |point: &Point| {
            let value = (panel.value)(&point.kernels[at].tally)?;
            Some((
                f64::from(point.exponent),
                value.log10().clamp(panel.floor, 17.0),
            ))
        };
        let values: Vec<_> = sweep.points.iter().filter_map(value).collect();
        if kernel.kernel == theirs::NAME {
            lines.push(Line {
                names: vec![theirs::NAME.into()],
                colour: INK,
                width: 5,
                values,
            });
            continue;
        }
        let name = match kernel.numbers.as_str() {
            "f64 on f32" => format!("{} (f64)", kernel.kernel),
            _ => kernel.kernel.clone(),
        };
        if !kernels.contains(&kernel.kernel.as_str()) {
            kernels.push(&kernel.kernel);
        }
        let is_near = |line: &&mut Line| {
            line.values.len() == values.len()
                && line
                    .values
                    .iter()
                    .zip(&values)
                    .all(|(a, b)| (a.1 - b.1).abs() < NEAR)
        };
        match lines.iter_mut().find(is_near) {
            Some(line) => line.names.push(name),
            None => {
                let place = kernels.iter().position(|name| *name == kernel.kernel);
                let colour = colour(place.unwrap_or_default());
                lines.push(Line {
                    names: vec![name],
                    colour,
                    width: 2,
                    values,
                });
            }
        }
    }
    lines
}
