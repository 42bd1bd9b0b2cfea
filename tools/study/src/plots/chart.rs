//! A chart as SVG: panels below each other, whose axes show powers of ten. Text and axes take the
//! text colour of the surrounding page, light or dark. On a page 350 pixels wide, text is 11 pixels
//! high.

use std::error::Error;

use plotters::coord::Shift;
use plotters::prelude::*;

/// The width, in SVG user units.
const WIDTH: u32 = 480;
/// The height of a panel without its legend.
const HEIGHT: i32 = 245;
/// From one line of text to the next.
const LINE: i32 = 22;
/// plotters divides the size by 1.24.
const FONT: (&str, f64) = ("inherit", 15.5 * 1.24);

/// Four colours after Okabe & Ito ("Color Universal Design", 2008) that are visible on both
/// light and dark backgrounds.
const COLOURS: [RGBColor; 4] = [
    RGBColor(0xd5, 0x5e, 0x00),
    RGBColor(0x3a, 0x8f, 0xd0),
    RGBColor(0x00, 0x9e, 0x73),
    RGBColor(0xcc, 0x79, 0xa7),
];

/// What the points of a series look like.
#[derive(Clone, Copy)]
pub enum Look {
    /// Lines by numbers: solid for `f64`, dashed for `f32`.
    Line(&'static str),
    /// Marks by numbers: discs for `f64`, crosses for `f32`, rings for `f64` on `f32` data.
    Mark(&'static str),
    /// A thin line to compare others with.
    Thin,
}

/// Points of one kernel.
pub struct Series {
    /// The kernel's place in the legend, which gives the colour.
    pub kernel: usize,
    /// What they look like.
    pub look: Look,
    /// The points.
    pub points: Vec<(f64, f64)>,
}

/// An axis.
pub struct Axis {
    /// What it shows.
    pub name: String,
    /// Its ends.
    pub ends: (f64, f64),
    /// How its numbers are labelled.
    pub label: fn(&f64) -> String,
}

impl Axis {
    fn over(name: &str, all: impl Iterator<Item = f64>, label: fn(&f64) -> String) -> Axis {
        let wider = |(low, high): (f64, f64), x: f64| (low.min(x), high.max(x));
        Axis {
            name: name.into(),
            ends: all.fold((f64::MAX, f64::MIN), wider),
            label,
        }
    }

    /// An axis for exponents, whose name says what 10^x is.
    pub fn exponents(name: &str, all: impl IntoIterator<Item = i32>) -> Axis {
        Axis::over(name, all.into_iter().map(f64::from), f64::to_string)
    }

    /// A logarithmic axis for numbers. Those below 0.1 are drawn at its lower end. Both ends are
    /// powers of ten, so that powers of ten are labelled, and not numbers such as 316 between them.
    pub fn logarithmic(name: &str, all: impl Iterator<Item = f64>) -> Axis {
        let axis = Axis::over(name, all.map(|x| x.max(0.1).log10()), power_of_ten);
        let ends = (axis.ends.0.floor(), axis.ends.1.ceil());
        Axis { ends, ..axis }
    }

    /// A logarithmic axis for shares of millions of questions. Its lower end stands for none.
    pub fn shares(name: &str) -> Axis {
        Axis {
            name: name.into(),
            ends: (-8.0, 0.0),
            label: |power| match *power {
                ..-7.0 => "none".into(),
                _ => power_of_ten(&(power + 2.0)) + " %",
            },
        }
    }

    fn clamp(&self, value: f64) -> f64 {
        value.clamp(self.ends.0, self.ends.1)
    }
}

fn power_of_ten(power: &f64) -> String {
    let number = 10f64.powf(*power);
    match *power {
        -2.0..0.0 => number.to_string(),
        0.0..4.0 => format!("{number:.0}"),
        _ => {
            let raised = |digit: char| match digit.to_digit(10) {
                Some(digit) => "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().nth(digit as usize),
                None => Some('⁻'),
            };
            let exponent = format!("{power:.0}");
            format!(
                "10{}",
                exponent.chars().filter_map(raised).collect::<String>()
            )
        }
    }
}

/// One of a chart's panels.
pub struct Panel<'a> {
    /// The names of kernels, whose colours are explained above the panel.
    pub legend: Vec<&'a str>,
    /// The horizontal axis.
    pub x: Axis,
    /// The vertical axis, whose name is the panel's title.
    pub y: Axis,
    /// What is drawn.
    pub series: Vec<Series>,
}

impl Panel<'_> {
    fn legend_height(&self) -> i32 {
        LINE * self.legend.len().div_ceil(2) as i32
    }
}

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// Draws some lines of text, and panels below them.
pub fn svg(notes: &[&str], panels: &[Panel]) -> String {
    let mut svg = String::new();
    draw(notes, panels, &mut svg).expect("drawing in memory cannot fail");
    svg.replace("#000000", "currentColor")
}

fn draw(notes: &[&str], panels: &[Panel], svg: &mut String) -> Result<(), Box<dyn Error>> {
    let of_notes = LINE * notes.len() as i32;
    let heights = panels.iter().map(|panel| panel.legend_height() + HEIGHT);
    let height = of_notes + heights.sum::<i32>();
    let all = SVGBackend::with_string(svg, (WIDTH, height as u32)).into_drawing_area();
    for (at, note) in notes.iter().enumerate() {
        all.draw(&Text::new(*note, (14, 4 + LINE * at as i32), FONT))?;
    }
    let (_, mut below) = all.split_vertically(of_notes);
    for panel in panels {
        let (legend, rest) = below.split_vertically(panel.legend_height());
        let (body, rest) = rest.split_vertically(HEIGHT);
        draw_panel(panel, &legend, &body)?;
        below = rest;
    }
    Ok(all.present()?)
}

fn draw_panel(panel: &Panel, legend: &Area, body: &Area) -> Result<(), Box<dyn Error>> {
    for (at, name) in panel.legend.iter().enumerate() {
        let (x, y) = (20 + 230 * (at as i32 % 2), 12 + LINE * (at as i32 / 2));
        legend.draw(&Circle::new((x, y), 5, COLOURS[at].filled()))?;
        legend.draw(&Text::new(*name, (x + 12, y - 9), FONT))?;
    }
    let (Panel { x, y, .. }, grid) = (panel, BLACK.mix(0.15));
    let mut chart = ChartBuilder::on(body)
        .caption(&y.name, FONT)
        .margin_right(24)
        .x_label_area_size(2 * LINE)
        .y_label_area_size(66)
        .build_cartesian_2d(x.ends.0..x.ends.1, y.ends.0..y.ends.1)?;
    let mut mesh = chart.configure_mesh();
    mesh.label_style(FONT).axis_desc_style(FONT).x_desc(&x.name);
    mesh.x_label_formatter(&x.label).x_labels(5);
    mesh.y_label_formatter(&y.label).y_labels(6);
    mesh.bold_line_style(grid).light_line_style(TRANSPARENT);
    mesh.axis_style(grid).draw()?;
    for series in &panel.series {
        let colour = COLOURS[series.kernel];
        let stroke = colour.stroke_width(2);
        let points = series.points.iter();
        let points: Vec<_> = points.map(|(p, q)| (x.clamp(*p), y.clamp(*q))).collect();
        match series.look {
            Look::Thin => chart.draw_series(LineSeries::new(points, BLACK.mix(0.6)))?,
            Look::Line("f32") => {
                let points = points.into_iter();
                chart.draw_series(DashedLineSeries::new(points, 5, 4, stroke))?
            }
            Look::Line(_) => chart.draw_series(LineSeries::new(points, stroke))?,
            Look::Mark("f32") => {
                chart.draw_series(points.into_iter().map(|at| Cross::new(at, 5, stroke)))?
            }
            Look::Mark(numbers) => {
                let style = if numbers == "f64" {
                    colour.filled()
                } else {
                    stroke
                };
                chart.draw_series(points.into_iter().map(|at| Circle::new(at, 5, style)))?
            }
        };
    }
    Ok(())
}
