//! Boxes whose faces are parallel to the axes.

use glam::DVec3;
use serde::{Deserialize, Serialize};

use crate::words::vector;

// ANCHOR: bounding_box
/// A solid box whose faces are parallel to the axes: all points p with
/// `min` ≤ p ≤ `max` in x, y and z. World space, scene units.
///
/// It may be flat: `min` and `max` may be equal along one axis or several.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct BoundingBox {
    /// The corner with the smallest x, y and z.
    pub min: DVec3,
    /// The corner with the greatest x, y and z.
    pub max: DVec3,
}

impl BoundingBox {
    /// Its centre.
    pub fn center(&self) -> DVec3 {
        0.5 * self.min + 0.5 * self.max
    }
}
// ANCHOR_END: bounding_box

impl BoundingBox {
    /// "from (0, 0, 0) to (1, 2, 3)".
    pub fn words(&self, digits: usize) -> String {
        let [min, max] = [self.min, self.max].map(|corner| vector(corner, digits));
        format!("from {min} to {max}")
    }

    /// Half of its surface's area, in square scene units.
    pub(crate) fn half_area(&self) -> f64 {
        let size = self.max - self.min;
        size.x * size.y + size.y * size.z + size.z * size.x
    }
}
