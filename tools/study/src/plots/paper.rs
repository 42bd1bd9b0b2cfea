//! What all plots share.

use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

/// Okabe & Ito's palette ("Color Universal Design", 2008), without yellow, which a light
/// ground swallows, and with a grey.
const COLOURS: [RGBColor; 8] = [
    RGBColor(213, 94, 0),
    RGBColor(0, 114, 178),
    RGBColor(0, 140, 105),
    RGBColor(204, 121, 167),
    RGBColor(86, 160, 213),
    RGBColor(200, 140, 0),
    RGBColor(20, 20, 20),
    RGBColor(120, 120, 120),
];

/// The ground.
pub const GROUND: RGBColor = RGBColor(252, 252, 250);
/// Text and axes.
pub const INK: RGBColor = RGBColor(50, 50, 50);
/// Lines of the grid.
pub const FAINT: RGBColor = RGBColor(224, 224, 220);

/// The colour of the kernel at a place in its list.
pub fn colour(at: usize) -> RGBColor {
    COLOURS[at % COLOURS.len()]
}

/// Text of a size in pixels.
pub fn text(size: i32, colour: RGBColor) -> TextStyle<'static> {
    let style = ("sans-serif", size).into_font().color(&colour);
    style.pos(Pos::new(HPos::Left, VPos::Center))
}

/// Moves labels apart, keeping their order, so that none overlaps the next or leaves the
/// room from `low` to `high`. A label has a place, its upper end, and a height.
pub fn spread<T>(labels: &mut [(f64, f64, T)], low: f64, high: f64) {
    labels.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut floor = low;
    for (place, height, _) in labels.iter_mut() {
        *place = place.max(floor);
        floor = *place + *height;
    }
    let mut ceiling = high;
    for (place, height, _) in labels.iter_mut().rev() {
        *place = place.min(ceiling - *height);
        ceiling = *place;
    }
}
