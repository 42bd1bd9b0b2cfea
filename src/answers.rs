//! What a submission hands to the harness: its six answers as plain functions.

use crate::camera::{Camera, Pixel, Resolution};
use crate::ray::{Hit, Intersection, Ray};
use crate::shape::{Canned, Plane, Shape, Sphere, Triangle, TriangleSoup};

/// A ray, met with a shape of type `S` from `min_t` on.
pub type Intersect<S> = fn(&S, &Ray, f64) -> Option<Intersection>;

/// The nearest object of type `S` along a ray from `min_t` on.
pub type FirstHit<S> = fn(&Ray, f64, &[S]) -> Option<Hit>;

/// The answers of one submission.
///
/// Plain function pointers keep the harness free of type parameters, and let each
/// answer be asked while the others are still `todo!`.
#[derive(Clone, Copy)]
pub struct Answers {
    /// The ray through a pixel's centre.
    pub viewing_ray: fn(&Camera, Pixel, Resolution) -> Ray,
    /// Over real shapes: what a film is cast with.
    pub first_hit: FirstHit<Shape>,
    /// Over canned objects: how `first_hit` is judged alone.
    pub first_hit_canned: FirstHit<Canned>,
    /// A ray and a sphere.
    pub sphere: Intersect<Sphere>,
    /// A ray and a plane.
    pub plane: Intersect<Plane>,
    /// A ray and a triangle.
    pub triangle: Intersect<Triangle>,
    /// A ray and a triangle soup.
    pub triangle_soup: Intersect<TriangleSoup>,
    /// A ray and a soup of canned objects: how the soup is judged alone.
    pub triangle_soup_canned: Intersect<TriangleSoup<Canned>>,
}

impl Answers {
    /// Asks the answer that belongs to this shape.
    pub(crate) fn intersect(&self, shape: &Shape, ray: &Ray, min_t: f64) -> Option<Intersection> {
        match shape {
            Shape::Sphere(sphere) => (self.sphere)(sphere, ray, min_t),
            Shape::Plane(plane) => (self.plane)(plane, ray, min_t),
            Shape::Triangle(triangle) => (self.triangle)(triangle, ray, min_t),
            Shape::Soup(soup) => (self.triangle_soup)(soup, ray, min_t),
        }
    }
}
