//! What the two loops cost, counted: the same triangles drawn by both.

use glam::{DVec2, dvec2};
use pinhole::Resolution;
use pinhole_course::checkout::Checkout;

use super::FigureFile;
use super::drawing::{Drawing, Side, Stroke, colour, ink, stroke};
use crate::error::Result;
use crate::rasterizer::{camera, rasterize, strewn};

/// Steps of both loops: the rasterizer's, and the brute-force ray caster's, which asks
/// every triangle for every pixel.
fn steps(count: usize, resolution: Resolution) -> [f64; 2] {
    let drawn = rasterize(&camera(), resolution, 1.0, &strewn(count, 0.3));
    [drawn.steps as f64, (count * resolution.pixels()) as f64]
}

/// As triangles are added.
pub fn loops_by_objects(_: &Checkout) -> Result<FigureFile> {
    let resolution = Resolution { n_x: 160, n_y: 90 };
    let counts = (0..=10).map(|half| 10f64.powf(f64::from(half) / 2.0).round());
    let points = counts.map(|count| (count, steps(count as usize, resolution)));
    Ok(plot(
        "triangles",
        Lines { at: 5, ..LOOPS },
        points.collect(),
    ))
}

/// As pixels are added.
pub fn loops_by_pixels(_: &Checkout) -> Result<FigureFile> {
    let sides = [1, 2, 4, 8, 16, 32, 64].map(|n| Resolution {
        n_x: 16 * n,
        n_y: 9 * n,
    });
    let points = sides.map(|side| (side.pixels() as f64, steps(1000, side)));
    Ok(plot("pixels", LOOPS, points.into()))
}

/// What the two lines of a plot are, and what is counted.
pub struct Lines {
    /// The lower line, then the upper one.
    pub names: [&'static str; 2],
    /// On which side of its line the lower one's name is.
    pub side: Side,
    /// At which point of both lines the names are.
    pub at: usize,
    /// The title of the axis.
    pub counted: &'static str,
}

const LOOPS: Lines = Lines {
    names: ["rasterizer", "ray caster"],
    side: Side::Below,
    at: 3,
    counted: "steps",
};

/// Both axes logarithmic, a grid line for each decade.
pub fn plot(across: &str, lines: Lines, points: Vec<(f64, [f64; 2])>) -> FigureFile {
    let decade = |value: f64| value.log10();
    let all = points.iter().flat_map(|(_, both)| both.iter().copied());
    let (least, most) = all.fold((f64::MAX, 0.0_f64), |(least, most), value| {
        (least.min(value), most.max(value))
    });
    let from = dvec2(decade(points[0].0).floor(), decade(least).floor());
    let to = dvec2(
        decade(points[points.len() - 1].0).ceil(),
        decade(most).ceil(),
    );
    // The drawing's unit across is a decade; upward, half of one.
    let place = |x: f64, y: f64| dvec2(decade(x), 0.5 * decade(y));
    let corner = |p: DVec2| dvec2(p.x, 0.5 * p.y);
    let (low, high) = (corner(from), corner(to));
    let mut drawing = Drawing::new(low - dvec2(0.8, 0.8), high + dvec2(0.25, 0.5));
    for x in from.x as i32..=to.x as i32 {
        let at = f64::from(x);
        drawing.line(dvec2(at, low.y), dvec2(at, high.y), &ink().thin());
        drawing.small(dvec2(at, low.y), Side::Below, &power(x));
    }
    for y in from.y as i32..=to.y as i32 {
        let at = 0.5 * f64::from(y);
        drawing.line(dvec2(low.x, at), dvec2(high.x, at), &ink().thin());
        drawing.small(dvec2(low.x, at), Side::Left, &power(y));
    }
    let middle = dvec2(0.5 * (low.x + high.x), low.y - 0.55);
    drawing.text(middle, Side::On, across);
    drawing.text(dvec2(low.x, high.y + 0.25), Side::On, lines.counted);
    let [below, above] = lines.names;
    let looks: [(&str, Side, Stroke); 2] = [
        (below, lines.side, stroke(colour(4)).thick()),
        (above, Side::Above, stroke(colour(5)).thick()),
    ];
    for (which, (name, side, look)) in looks.iter().enumerate() {
        let line: Vec<DVec2> = points
            .iter()
            .map(|(x, both)| place(*x, both[which]))
            .collect();
        drawing.path(&line, false, "none", look);
        for at in &line {
            drawing.dot(*at, &look.colour);
        }
        // Clear of the line's slope.
        let aside = match side {
            Side::Above => dvec2(-0.1, 0.12) * (high.x - low.x) / 2.0,
            _ => dvec2(0.1, -0.12) * (high.x - low.x) / 2.0,
        };
        drawing.on_lines(line[lines.at] + aside, *side, name);
    }
    drawing.made()
}

/// A power of ten as it is written.
fn power(exponent: i32) -> String {
    match exponent {
        0 => "1".into(),
        1 => "10".into(),
        _ => {
            let digits = ["⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"];
            let written = exponent.to_string();
            let raised = written
                .bytes()
                .map(|digit| digits[usize::from(digit - b'0')]);
            format!("10{}", raised.collect::<String>())
        }
    }
}
