//! The book's numbers: asked of the reference, or computed by the formula of the chapter.
//!
//! What the reference does not return, such as a discriminant, is computed here, and a test
//! compares it with what the reference does return.

pub mod boxes;
mod camera;
mod effort;
pub mod nine_pixels;
pub mod savings;
mod shapes;

use glam::DVec3;
use pinhole::words::number;
use pinhole_course::checkout::Checkout;

use crate::error::Result;
use crate::record;
use crate::reference::Reference;
use crate::silhouette::{DISTANCES, WAYS, wrong};
pub use camera::{PIXEL, on_plane, slide};
pub use shapes::{PLANE, Quadratic, RAY, SPHERE, TRIANGLE, weights};

pub use crate::record::Values;

/// Digits of every number shown, as `explain` shows them.
const DIGITS: usize = 6;

/// All numbers of the book.
pub fn values(checkout: &Checkout) -> Result<Values> {
    let reference = Reference::build(checkout)?;
    let mut values = Values::new();
    camera::add(&mut values, &reference, checkout)?;
    shapes::add(&mut values, &reference)?;
    nine_pixels::add(&mut values, &reference)?;
    boxes::add(&mut values, checkout)?;
    effort::add(&mut values, checkout)?;
    let colours = pinhole::false_colour::OBJECT_COLOURS;
    for (name, meets) in WAYS {
        for far in DISTANCES {
            let name = format!("afar_{name}_{far:e}");
            values.insert(name, wrong(meets, far).to_string());
        }
    }
    values.insert("object_colours".into(), colours.to_string());
    record::add(&mut values, checkout)?;
    Ok(values)
}

/// A number as the book shows it.
pub(crate) fn shown(value: f64) -> String {
    number(value, DIGITS)
}

/// A vector as the book shows it.
pub(crate) fn vector(DVec3 { x, y, z }: DVec3) -> String {
    format!("({}, {}, {})", shown(x), shown(y), shown(z))
}

#[cfg(test)]
mod tests;
