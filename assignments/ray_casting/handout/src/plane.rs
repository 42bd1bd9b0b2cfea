use pinhole::{Intersection, Plane, Ray};

use crate::intersect_ray::IntersectRay;

// ANCHOR: stub
impl IntersectRay for Plane {
    /// Where a ray meets a plane, at `min_t` or beyond.
    ///
    /// The plane is all points p with (p − `self.point`) · `self.normal` = 0. It
    /// has no edge and is seen from both sides. `self.normal` may have any length.
    ///
    /// The answer's normal is the plane's own, scaled to unit length. Never flip it
    /// towards the ray. `None` if the ray is parallel to the plane, or meets it before `min_t`.
    ///
    /// Book: Plane.
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        todo!("plane")
    }
}
// ANCHOR_END: stub
