//! Drawings in SVG: lines, arrows, dots and words at computed places.

use std::fmt::Write as _;

use glam::{DVec2, DVec3, dvec2};
use pinhole::false_colour;

use super::FigureFile;
use crate::html::escaped;

/// How wide every drawing is on the page, in CSS pixels. On a phone, whose pages are
/// 350 wide, the smallest words are 11 high.
pub const WIDTH: f64 = 480.0;

/// The size of words, and of smaller ones.
const SIZES: [f64; 2] = [17.0, 15.5];

/// A drawing. Places are in its own units, y upward.
pub struct Drawing {
    height: f64,
    origin: DVec2,
    scale: f64,
    parts: String,
}

/// The colour of the page's text, light or dark.
pub const INK: &str = "currentColor";

/// The colour of an object in `id` pictures.
pub fn colour(object: usize) -> String {
    let [r, g, b] = false_colour::object(object).0;
    format!("#{r:02x}{g:02x}{b:02x}")
}

/// On which side of its place a word is.
#[derive(Clone, Copy, Debug)]
pub enum Side {
    /// The word ends before the place.
    Left,
    /// The word is centred above the place.
    Above,
    /// The word is centred below the place.
    Below,
    /// The word begins after the place.
    Right,
    /// The word is centred on the place.
    On,
}

/// How a line looks.
#[derive(Clone, Debug)]
pub struct Stroke {
    /// An SVG colour.
    pub colour: String,
    /// The line's width, in units of the page.
    pub width: f64,
    /// Whether the line is dashed.
    pub dashed: bool,
}

/// A line in ink.
pub fn ink() -> Stroke {
    stroke(INK)
}

/// A line in a colour.
pub fn stroke(colour: impl Into<String>) -> Stroke {
    Stroke {
        colour: colour.into(),
        width: 1.5,
        dashed: false,
    }
}

impl Stroke {
    /// The same line, but dashed and thinner.
    pub fn dashed(self) -> Stroke {
        Stroke {
            dashed: true,
            width: 1.0,
            ..self
        }
    }

    /// The same line, but thin.
    pub fn thin(self) -> Stroke {
        Stroke { width: 0.7, ..self }
    }

    /// The same line, but thick.
    pub fn thick(self) -> Stroke {
        Stroke { width: 3.0, ..self }
    }

    fn attributes(&self) -> String {
        let dashes = match self.dashed {
            true => " stroke-dasharray=\"5 4\"",
            false => "",
        };
        format!(
            "stroke=\"{}\" stroke-width=\"{}\"{dashes}",
            self.colour, self.width
        )
    }
}

impl Drawing {
    /// Shows places from `from` (lower left) to `to`.
    pub fn new(from: DVec2, to: DVec2) -> Drawing {
        let scale = WIDTH / (to.x - from.x);
        Drawing {
            height: scale * (to.y - from.y),
            origin: from,
            scale,
            parts: String::new(),
        }
    }

    fn place(&self, p: DVec2) -> (f64, f64) {
        let p = (p - self.origin) * self.scale;
        (p.x, self.height - p.y)
    }

    /// A line.
    pub fn line(&mut self, from: DVec2, to: DVec2, stroke: &Stroke) {
        self.path(&[from, to], false, "none", stroke);
    }

    /// An arrow to `to`.
    pub fn arrow(&mut self, from: DVec2, to: DVec2, stroke: &Stroke) {
        let along = (to - from).normalize_or_zero() * (5.0 + 2.0 * stroke.width) / self.scale;
        self.line(from, to - 0.6 * along, stroke);
        let side = 0.4 * along.perp();
        let head = [to, to - along + side, to - along - side];
        let fill = stroke.colour.clone();
        self.area(&head, &fill, 1.0);
    }

    /// A line through several places.
    pub fn path(&mut self, places: &[DVec2], closed: bool, fill: &str, stroke: &Stroke) {
        let mut d = String::new();
        for (number, place) in places.iter().enumerate() {
            let (x, y) = self.place(*place);
            let _infallible = write!(d, "{}{x:.1} {y:.1}", if number == 0 { "M" } else { "L" });
        }
        let close = if closed { "Z" } else { "" };
        let look = stroke.attributes();
        self.add(&format!("<path d=\"{d}{close}\" fill=\"{fill}\" {look} />"));
    }

    /// The outlines of many triangles, as one element: half a pixel is near enough.
    pub fn mesh(&mut self, triangles: &[[DVec2; 3]], stroke: &Stroke) {
        let mut d = String::new();
        for triangle in triangles {
            let [(a, b), (c, e), (f, g)] = triangle.map(|corner| self.place(corner));
            let _infallible = write!(d, "M{a:.0} {b:.0}L{c:.0} {e:.0}L{f:.0} {g:.0}Z");
        }
        let look = stroke.attributes();
        self.add(&format!("<path d=\"{d}\" fill=\"none\" {look} />"));
    }

    /// A filled area without a border.
    pub fn area(&mut self, places: &[DVec2], fill: &str, opacity: f64) {
        let points = places.iter().map(|place| {
            let (x, y) = self.place(*place);
            format!("{x:.1},{y:.1}")
        });
        let points: Vec<String> = points.collect();
        let points = points.join(" ");
        self.add(&format!(
            "<polygon points=\"{points}\" fill=\"{fill}\" fill-opacity=\"{opacity}\" />"
        ));
    }

    /// A circle in the drawing's units; `fill` may be `none`.
    pub fn circle(
        &mut self,
        center: DVec2,
        radius: f64,
        fill: &str,
        opacity: f64,
        stroke: &Stroke,
    ) {
        let (x, y) = self.place(center);
        let (r, look) = (radius * self.scale, stroke.attributes());
        self.add(&format!(
            "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"{r:.1}\" fill=\"{fill}\" \
             fill-opacity=\"{opacity}\" {look} />"
        ));
    }

    /// A dot, the same size in every drawing.
    pub fn dot(&mut self, place: DVec2, fill: &str) {
        self.circle(place, 4.0 / self.scale, fill, 1.0, &ink());
    }

    /// A circle that marks a place, not filled.
    pub fn ring(&mut self, place: DVec2) {
        self.circle(place, 4.0 / self.scale, "none", 1.0, &ink());
    }

    /// Words beside a place; between two `*` they are bold, as vectors are.
    pub fn text(&mut self, place: DVec2, side: Side, words: &str) {
        self.sized(place, side, words, SIZES[0]);
    }

    /// Smaller words beside a place.
    pub fn small(&mut self, place: DVec2, side: Side, words: &str) {
        self.sized(place, side, words, SIZES[1]);
    }

    /// Words that lines pass behind: the page's style gives them a rim of its own colour.
    pub fn on_lines(&mut self, place: DVec2, side: Side, words: &str) {
        self.parts.push_str("<g class=\"on-lines\">\n");
        self.text(place, side, words);
        self.parts.push_str("</g>\n");
    }

    fn sized(&mut self, place: DVec2, side: Side, words: &str, size: f64) {
        let (x, y) = self.place(place);
        let (dx, dy, anchor) = match side {
            Side::Left => (-8.0, 0.35 * size, "end"),
            Side::Right => (8.0, 0.35 * size, "start"),
            Side::Above => (0.0, -9.0, "middle"),
            Side::Below => (0.0, 9.0 + 0.75 * size, "middle"),
            Side::On => (0.0, 0.35 * size, "middle"),
        };
        let mut text = String::new();
        for (number, part) in words.split('*').enumerate() {
            let part = escaped(part);
            let _infallible = match number % 2 {
                1 => write!(text, "<tspan font-weight=\"bold\">{part}</tspan>"),
                _ => write!(text, "{part}"),
            };
        }
        let (x, y) = (x + dx, y + dy);
        self.add(&format!(
            "<text x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"{anchor}\" font-size=\"{size}\" \
             fill=\"{INK}\">{text}</text>"
        ));
    }

    fn add(&mut self, part: &str) {
        self.parts.push_str(part);
        self.parts.push('\n');
    }

    /// The file. It has no empty line, so that Markdown takes it as one piece.
    pub fn made(self) -> FigureFile {
        let Drawing { height, parts, .. } = self;
        let content = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {height:.0}\" \
             width=\"{WIDTH}\" height=\"{height:.0}\">\n{parts}</svg>\n"
        );
        FigureFile {
            extension: "svg",
            content: content.into_bytes(),
        }
    }
}

/// A way to draw space: along which directions of the drawing its axes run.
#[derive(Clone, Copy, Debug)]
pub struct Space {
    /// Where x, y and z run.
    pub axes: [DVec2; 3],
}

impl Space {
    /// y upward, x to the right, z towards the viewer and to the left.
    pub fn slanted() -> Space {
        Space {
            axes: [dvec2(0.94, 0.14), dvec2(0.0, 1.0), dvec2(-0.5, -0.3)],
        }
    }

    /// The place of a point of space in the drawing.
    pub fn at(&self, p: DVec3) -> DVec2 {
        p.x * self.axes[0] + p.y * self.axes[1] + p.z * self.axes[2]
    }
}
