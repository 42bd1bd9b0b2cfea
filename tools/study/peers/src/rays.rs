//! The rays of a camera.

use pinhole_study::shape;
use pinhole_study::vector::Vector;

/// A ray in `f32`; the direction need not be unit length.
pub type Ray = shape::Ray<f32>;

/// Pixels in a row and in a column.
const SIDE: u32 = 256;

/// Rays of a camera at distance 3 from the centre of a mesh of radius 1, which fills the image.
pub fn primary() -> Vec<Ray> {
    let at = |pixel: u32| (f64::from(pixel) + 0.5) / f64::from(SIDE) * 0.8 - 0.4;
    let ray = |index: u32| {
        let (x, y) = (at(index % SIDE), at(index / SIDE));
        Ray {
            origin: Vector::new(2.0, 1.0, 2.0),
            direction: Vector::new(-2.0 / 3.0 + 0.6 * x, -1.0 / 3.0 + y, -2.0 / 3.0 - 0.6 * x)
                .map(|number| number as f32),
        }
    };
    (0..SIDE * SIDE).map(ray).collect()
}
