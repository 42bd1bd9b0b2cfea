use pinhole::{Intersection, Plane, Ray};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Plane {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        if ray.direction.dot(self.normal) == 0.0 {
            return None;
        }
        let normal = self.normal.normalize();
        let t = (self.point - ray.origin).dot(normal).abs();
        if t < min_t {
            return None;
        }
        Some(Intersection { t, normal })
    }
}
