//! Rays and what they hit.

use glam::DVec3;
use serde::{Deserialize, Serialize};

// ANCHOR: ray
/// A ray p(t) = e + t **d**, in world space (Marschner & Shirley, 4th ed., §4.2).
///
/// The direction is **not** a unit vector: a perspective camera's rays have
/// **d** = s − e with s on the image plane, so t = 1 lies on that plane and
/// t counts in multiples of |**d**|.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Ray {
    /// e, where t = 0; world space, scene units.
    pub origin: DVec3,
    /// **d**, from t = 0 to t = 1; world space, any length but zero.
    pub direction: DVec3,
}

impl Ray {
    /// The point p(t) = e + t **d**, in world space.
    pub fn at(&self, t: f64) -> DVec3 {
        self.origin + t * self.direction
    }
}
// ANCHOR_END: ray

// ANCHOR: hit
/// Where a ray meets a surface.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Intersection {
    /// The ray's parameter at the surface, in multiples of the direction's length.
    pub t: f64,
    /// The unit **outward** normal, world space: away from a sphere's centre (also
    /// when seen from inside), a plane's own normal, t₁ × t₂ of a triangle. It is
    /// never flipped towards the ray.
    pub normal: DVec3,
}

/// The nearest intersection of a ray with a list of objects.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Hit {
    /// The object's place in the list, counted from 0.
    pub object: usize,
    /// Where on that object.
    pub intersection: Intersection,
}
// ANCHOR_END: hit
