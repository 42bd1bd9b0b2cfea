//! Shared by all plots: a canvas, and panels with logarithmic axes.

use std::fmt::Write;

/// The width of every plot, in SVG user units.
pub const WIDTH: f64 = 480.0;

/// The font size: 11 pixels on a page that is 350 wide.
const WORDS: f64 = 15.5;

/// Four colours after Okabe & Ito ("Color Universal Design", 2008) that are visible on both
/// light and dark backgrounds.
const COLOURS: [&str; 4] = ["#d55e00", "#3a8fd0", "#009e73", "#cc79a7"];

/// The colour of the page's text.
pub const INK: &str = "currentColor";

/// The colour of the kernel at this index.
pub fn colour(at: usize) -> &'static str {
    COLOURS.get(at).copied().unwrap_or(INK)
}

/// The alignment of text about its position.
#[derive(Clone, Copy)]
pub enum Anchor {
    /// The text begins at the position.
    Start,
    /// The text is centred on the position.
    Middle,
    /// The text ends at the position.
    End,
}

/// SVG attributes of grid lines.
pub const GRID: &str = "stroke=\"currentColor\" stroke-width=\"1\" stroke-opacity=\"0.15\"";

/// SVG attributes of a kernel's curve; curves of `f32` are dashed.
pub fn curve(colour: &str, numbers: &str) -> String {
    let dashes = match numbers {
        "f32" => " stroke-dasharray=\"5 4\"",
        _ => "",
    };
    format!("stroke=\"{colour}\" stroke-width=\"2.5\"{dashes}")
}

/// A plot under construction; y points down.
#[derive(Default)]
pub struct Paper(String);

impl Paper {
    /// Draws text, vertically centred at y.
    pub fn word(&mut self, (x, y): (f64, f64), anchor: Anchor, words: &str) {
        let anchor = match anchor {
            Anchor::Start => "start",
            Anchor::Middle => "middle",
            Anchor::End => "end",
        };
        let y = y + 0.35 * WORDS;
        let words = words.replace('&', "&amp;").replace('<', "&lt;");
        let _ = writeln!(
            self.0,
            "<text x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"{anchor}\">{words}</text>"
        );
    }

    /// Draws a polyline with these SVG attributes.
    pub fn line(&mut self, points: &[(f64, f64)], look: &str) {
        let place = |(x, y): &(f64, f64)| format!("{x:.1},{y:.1}");
        let places: Vec<String> = points.iter().map(place).collect();
        let places = places.join(" ");
        let _ = writeln!(
            self.0,
            "<polyline points=\"{places}\" fill=\"none\" {look}/>"
        );
    }

    /// Draws a disc, or a ring if it is not filled.
    pub fn dot(&mut self, (x, y): (f64, f64), radius: f64, colour: &str, is_filled: bool) {
        let fill = if is_filled { colour } else { "none" };
        let _ = writeln!(
            self.0,
            "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"{radius}\" fill=\"{fill}\" \
             stroke=\"{colour}\" stroke-width=\"2\"/>"
        );
    }

    /// Draws a cross.
    pub fn cross(&mut self, (x, y): (f64, f64), size: f64, colour: &str) {
        let look = format!("stroke=\"{colour}\" stroke-width=\"2\"");
        for rise in [-size, size] {
            self.line(&[(x - size, y - rise), (x + size, y + rise)], &look);
        }
    }

    /// Draws a bar that begins at x, vertically centred at y.
    pub fn bar(&mut self, (x, y): (f64, f64), length: f64, height: f64, colour: &str) {
        let _ = writeln!(
            self.0,
            "<rect x=\"{x:.1}\" y=\"{:.1}\" width=\"{length:.1}\" height=\"{height}\" \
             fill=\"{colour}\"/>",
            y - height / 2.0
        );
    }

    /// The SVG document.
    pub fn svg(self, height: f64) -> String {
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {height:.0}\" \
             width=\"{WIDTH}\" font-size=\"{WORDS}\" font-family=\"inherit\" \
             fill=\"currentColor\">\n{}</svg>\n",
            self.0
        )
    }
}

/// A panel of a plot with logarithmic axes.
pub struct Panel {
    /// Its upper end.
    pub top: f64,
    /// Its lower end.
    pub bottom: f64,
    /// Powers of ten at its left and right ends.
    pub x: (f64, f64),
    /// Powers of ten at its lower and upper ends.
    pub y: (f64, f64),
}

const LEFT: f64 = 66.0;
const RIGHT: f64 = WIDTH - 24.0;

impl Panel {
    /// The position of two powers of ten, clamped to the panel.
    pub fn at(&self, x: f64, y: f64) -> (f64, f64) {
        let share =
            |value: f64, (low, high): (f64, f64)| ((value - low) / (high - low)).clamp(0.0, 1.0);
        let across = LEFT + share(x, self.x) * (RIGHT - LEFT);
        let up = self.bottom - share(y, self.y) * (self.bottom - self.top);
        (across, up)
    }

    /// Draws horizontal grid lines with their labels.
    pub fn rows(&self, paper: &mut Paper, ticks: &[(f64, String)]) {
        for (y, words) in ticks {
            let y = self.at(0.0, *y).1;
            paper.line(&[(LEFT, y), (RIGHT, y)], GRID);
            paper.word((LEFT - 8.0, y), Anchor::End, words);
        }
    }

    /// Draws up to about eight vertical grid lines with their labels, and the name of the axis.
    /// The labels are powers of ten, with the sign reversed if `of_a_tenth`.
    pub fn columns(&self, paper: &mut Paper, meaning: &str, of_a_tenth: bool) {
        let (low, high) = self.x;
        let steps = [0.5, 1.0, 2.0, 3.0, 5.0, 10.0, 20.0, 50.0, 100.0];
        let step = steps.into_iter().find(|step| (high - low) / step <= 7.0);
        let step = step.unwrap_or(100.0);
        let first = (low / step).ceil() as i32;
        let last = (high / step).floor() as i32;
        for tick in first..=last {
            let power = f64::from(tick) * step;
            let x = self.at(power, 0.0).0;
            paper.line(&[(x, self.top), (x, self.bottom)], GRID);
            let words = number(if of_a_tenth { -power } else { power });
            paper.word((x, self.bottom + 14.0), Anchor::Middle, &words);
        }
        let middle = (LEFT + RIGHT) / 2.0;
        paper.word((middle, self.bottom + 34.0), Anchor::Middle, meaning);
    }
}

/// A label for a power of ten, or for three times one.
pub fn number(power: f64) -> String {
    let whole = power.floor() as i32;
    let first = if power > power.floor() { 3 } else { 1 };
    match whole {
        0..=3 => format!("{}", first * 10i32.pow(whole as u32)),
        _ => format!("10{}", raised(whole)),
    }
}

fn raised(exponent: i32) -> String {
    let digit = |c: char| match c.to_digit(10) {
        Some(digit) => "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().nth(digit as usize).unwrap_or(c),
        None => '⁻',
    };
    exponent.to_string().chars().map(digit).collect()
}

/// A logarithmic axis for shares of wrong decisions, with a separate place below for none.
pub struct Shares {
    /// The place of "none".
    pub none: f64,
    /// The ends of the axis.
    pub y: (f64, f64),
}

impl Shares {
    /// The axis for shares of this many questions.
    pub fn of(asked: u64) -> Shares {
        let smallest = -(asked.max(10) as f64).log10();
        let none = smallest.floor() - 1.0;
        Shares {
            none,
            y: (none - 0.3, 0.0),
        }
    }

    /// The place of a share.
    pub fn at(&self, wrong: u64, asked: u64) -> f64 {
        match wrong {
            0 => self.none,
            _ => (wrong as f64 / asked.max(1) as f64).log10(),
        }
    }

    /// A tick at every second power of ten, and at "none".
    pub fn ticks(&self) -> Vec<(f64, String)> {
        let mut ticks = vec![(self.none, "none".to_owned())];
        for (power, words) in [(0.0, "100 %"), (-2.0, "1 %"), (-4.0, "0.01 %")] {
            if power > self.none + 0.9 {
                ticks.push((power, words.into()));
            }
        }
        ticks
    }
}

/// Ticks for errors in ulp.
pub fn ulps(highest: f64) -> Vec<(f64, String)> {
    let step = if highest > 9.0 { 4 } else { 2 };
    let last = highest.ceil() as i32;
    (0..=last)
        .step_by(step)
        .map(|power| (f64::from(power), number(f64::from(power))))
        .collect()
}

/// Draws a legend of kernels by colour, two per row, and returns the y below it.
pub fn legend(paper: &mut Paper, y: f64, names: &[&str]) -> f64 {
    for (at, name) in names.iter().enumerate() {
        let (x, y) = (20.0 + 230.0 * (at % 2) as f64, y + 22.0 * (at / 2) as f64);
        paper.dot((x, y), 5.0, colour(at), true);
        paper.word((x + 12.0, y), Anchor::Start, name);
    }
    y + 22.0 * names.len().div_ceil(2) as f64
}

/// The distinct names in alphabetical order, so that a kernel has the same colour in all plots.
pub fn names<'a>(all: impl Iterator<Item = &'a str>) -> Vec<&'a str> {
    let mut names = Vec::new();
    for name in all {
        if !names.contains(&name) {
            names.push(name);
        }
    }
    names.sort_unstable();
    names
}
