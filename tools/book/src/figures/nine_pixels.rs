//! The scene that grows through the book: nine pixels, and what lies between their rays.

use image::{Rgb, Rgba};
use pinhole::{Resolution, Scene, false_colour};
use pinhole_course::checkout::Checkout;

use super::FigureFile;
use super::pictures::{GAP, made};
use crate::error::Result;
use crate::png::{beside, enlarged, opaque};
use crate::reference::Reference;
use crate::worked::nine_pixels::{RESOLUTION, camera, objects};

/// The width and height of both pictures.
const SIZE: usize = 300;

/// The plane.
pub fn nine_plane(checkout: &Checkout) -> Result<FigureFile> {
    nine(1, checkout)
}

/// The plane and the sphere.
pub fn nine_sphere(checkout: &Checkout) -> Result<FigureFile> {
    nine(2, checkout)
}

/// The plane, the sphere and the triangle.
pub fn nine_triangle(checkout: &Checkout) -> Result<FigureFile> {
    nine(3, checkout)
}

/// The first `count` objects, in nine pixels and in many, with the nine rays as dots.
fn nine(count: usize, checkout: &Checkout) -> Result<FigureFile> {
    let reference = Reference::build(checkout)?;
    let shapes = objects().into_iter().map(|(_, shape)| shape);
    let mut scene = Scene {
        camera: camera()?,
        resolution: RESOLUTION,
        min_t: 1.0,
        objects: shapes.take(count).collect(),
    };
    let pixel = (SIZE / RESOLUTION.n_x) as u32;
    let mut coarse = enlarged(&false_colour::id(&reference.film(&scene)?), pixel);
    for (x, y, colour) in coarse.enumerate_pixels_mut() {
        // Make the lines two pixels wide, because a phone shows about every second pixel.
        if x % pixel < 2 || y % pixel < 2 {
            let [r, g, b, _] = colour.0.map(|value| value / 2);
            *colour = Rgba([r, g, b, 255]);
        }
    }
    scene.resolution = Resolution {
        n_x: SIZE,
        n_y: SIZE,
    };
    let mut fine = false_colour::id(&reference.film(&scene)?);
    let from_centre = |place: u32| (place % pixel) as f64 + 0.5 - f64::from(pixel) / 2.0;
    for (x, y, colour) in fine.enumerate_pixels_mut() {
        if from_centre(x).hypot(from_centre(y)) < 4.0 {
            *colour = Rgb([255; 3]);
        }
    }
    made(&beside(&[coarse, opaque(&fine)], GAP))
}
