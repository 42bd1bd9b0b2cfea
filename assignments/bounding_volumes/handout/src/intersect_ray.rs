//! The question that `triangle.rs` answers, as in the first assignment.

use pinhole::{Intersection, Ray};

/// A surface that a ray can meet.
pub trait IntersectRay {
    /// The first point of this surface along `ray`, at `min_t` or beyond. `None` if there is none.
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection>;
}
