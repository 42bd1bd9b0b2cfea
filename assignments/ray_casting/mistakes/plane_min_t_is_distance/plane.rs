use pinhole::{Intersection, Plane, Ray};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Plane {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let denominator = ray.direction.dot(self.normal);
        if denominator == 0.0 {
            return None;
        }
        let t = self.normal.dot(self.point - ray.origin) / denominator;
        let distance = t * ray.direction.length();
        if distance < min_t {
            return None;
        }
        Some(Intersection {
            t,
            normal: self.normal.normalize(),
        })
    }
}
