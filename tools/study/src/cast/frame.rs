//! A scene's local coordinates, in which boxes are stored in `f32`.

use crate::number::{Real, exponent};
use crate::vector::Vector;

/// local = (world − `center`) 2^−`exponent`. All boxed parts of a scene lie between −1 and 1 in
/// this frame, wherever the scene is and however large it is.
#[derive(Clone, Copy, Debug, Default)]
pub struct Frame {
    center: Vector<f64>,
    /// A length of 2^`exponent` in the world has length 1 in the frame.
    pub exponent: i32,
}

impl Frame {
    /// The frame of a box, given by two opposite corners with coordinates below 1e300. Its centre
    /// is that of the box, or the eye from which all rays start.
    pub fn around([low, high]: [Vector<f64>; 2], eye: Option<Vector<f64>>) -> Frame {
        let center = eye.unwrap_or(low * 0.5 + high * 0.5);
        let size = (high - center).largest().max((center - low).largest());
        // The box of a single point has size 0.
        let size = size.max(center.largest() * 1e-9).max(1e-280);
        Frame {
            center,
            exponent: exponent(size) + 1,
        }
    }

    /// A point of the world in local coordinates, with a relative error of u.
    #[inline(always)]
    pub fn local(&self, point: Vector<f64>) -> Vector<f64> {
        (point - self.center).map(|x| x.times_power_of_two(-self.exponent))
    }

    /// A box in local coordinates that encloses the given one: each number is rounded to `f32`,
    /// then moved outwards to the next `f32`, and by 2⁻⁹⁶.
    pub fn boxed(&self, [low, high]: [Vector<f64>; 2]) -> [[f32; 3]; 2] {
        const MARGIN: f32 = 1.3e-29;
        let below = |x: f64| (x as f32).next_down() - MARGIN;
        let above = |x: f64| (x as f32).next_up() + MARGIN;
        [
            self.local(low).map(below).array(),
            self.local(high).map(above).array(),
        ]
    }
}
