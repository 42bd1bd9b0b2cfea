//! The question that every shape answers. You need not change this file: answer it
//! in `sphere.rs`, `plane.rs`, `triangle.rs` and `triangle_soup.rs`.

use pinhole::{Canned, Intersection, Ray, Shape};

/// A surface that a ray can meet.
pub trait IntersectRay {
    /// The first point of this surface along `ray`, at `min_t` or beyond.
    ///
    /// `min_t` and the answer's `t` are the ray's parameter: multiples of
    /// `ray.direction`, whatever its length. `min_t` is never negative. The answer's
    /// normal has unit length and points outward; it is never flipped towards the
    /// ray. `None` if there is no such point.
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection>;
}

impl IntersectRay for Shape {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        match self {
            Shape::Sphere(sphere) => answer(sphere, ray, min_t),
            Shape::Plane(plane) => answer(plane, ray, min_t),
            Shape::Triangle(triangle) => answer(triangle, ray, min_t),
            Shape::Soup(soup) => answer(soup, ray, min_t),
            other => panic!("this assignment has no {}", other.kind()),
        }
    }
}

/// Calls one of the four answers. The compiler must not merge this call into its caller, because all
/// four would then need as much stack as the one with the largest local variables.
#[inline(never)]
fn answer(surface: &impl IntersectRay, ray: &Ray, min_t: f64) -> Option<Intersection> {
    surface.intersect_ray(ray, min_t)
}

/// Replaces real objects when `first_hit` and the soup are tested alone.
impl IntersectRay for Canned {
    #[track_caller]
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        self.intersect(ray, min_t)
    }
}
