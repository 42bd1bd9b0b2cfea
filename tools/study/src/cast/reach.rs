//! From where rays come, so that what bounds rounding need not be worked out for each.

use super::world::{Part, Primitive};
use crate::vector::{Vector, around};

/// A cube around a scene, a few times as large.
#[derive(Clone, Copy, Debug, Default)]
pub struct Reach {
    center: Vector<f64>,
    /// Half the cube's side.
    radius: f64,
}

/// A camera is seldom further away than so many times the size of what it sees.
const SIZES: f64 = 8.0;

impl Reach {
    /// Around all that is finite.
    pub fn around(parts: &[Part]) -> Reach {
        let ends = |part: &Part| {
            let anchor = part.shape.anchor();
            part.shape.bounds().unwrap_or([anchor, anchor])
        };
        let Some([low, high]) = around(parts.iter().map(ends)) else {
            return Reach::default();
        };
        let center = low * 0.5 + high * 0.5;
        let size = (high - center).largest();
        // A lone plane has no size.
        let is_flat = parts
            .iter()
            .all(|part| matches!(part.shape, Primitive::Plane(_)));
        let size = if is_flat {
            size.max(center.largest()).max(1.0)
        } else {
            size
        };
        Reach {
            center,
            radius: SIZES * size,
        }
    }

    /// How far a point of a part is, in each component, from a ray's origin at most. What
    /// is rounded here is less than the room that every bound has.
    pub fn away(&self, anchor: Vector<f64>) -> f64 {
        (anchor - self.center).largest() + self.radius
    }

    /// Whether a ray from here is within reach. Others are asked with bounds of their own,
    /// which takes longer.
    #[inline(always)]
    pub fn holds(&self, origin: Vector<f64>) -> bool {
        (origin - self.center).largest() <= self.radius
    }
}
