use pinhole::{Intersection, Ray, Sphere};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Sphere {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let from_center = ray.origin - self.center;
        let a = ray.direction.length_squared();
        let h = ray.direction.dot(from_center);
        let c = from_center.length_squared() - self.radius * self.radius;
        let discriminant = h * h - a * c;
        if discriminant < 0.0 {
            return None;
        }
        let root = discriminant.sqrt();

        let t = (-h - root) / a;
        if t < min_t {
            return None;
        }
        Some(Intersection {
            t,
            normal: 2.0 * (ray.at(t) - self.center),
        })
    }
}
