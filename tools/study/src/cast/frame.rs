//! A scene's own measure, in which boxes are told in `f32`.

use crate::number::{Real, exponent};
use crate::vector::Vector;

/// local = (world − `center`) 2^−`exponent`: the boxed parts of a scene lie between −1
/// and 1, wherever they are in the world and however large.
#[derive(Clone, Copy, Debug, Default)]
pub struct Frame {
    center: Vector<f64>,
    /// Of the power of two that is 1 in the frame.
    pub exponent: i32,
}

impl Frame {
    /// Around all between two corners, whose numbers are below 1e300.
    pub fn around([low, high]: [Vector<f64>; 2]) -> Frame {
        let center = low * 0.5 + high * 0.5;
        let size = (high - center).largest().max((center - low).largest());
        // A single point has no size.
        let size = size.max(center.largest() * 1e-9).max(1e-280);
        Frame {
            center,
            exponent: exponent(size) + 1,
        }
    }

    /// A point of the world; off by u of itself.
    #[inline(always)]
    pub fn local(&self, point: Vector<f64>) -> Vector<f64> {
        (point - self.center).map(|x| x.times_power_of_two(-self.exponent))
    }

    /// A box, with room to spare: each number is rounded to `f32` and then moved outwards
    /// to the next.
    pub fn boxed(&self, [low, high]: [Vector<f64>; 2]) -> [[f32; 3]; 2] {
        [
            self.local(low).map(|x| (x as f32).next_down()).array(),
            self.local(high).map(|x| (x as f32).next_up()).array(),
        ]
    }
}
