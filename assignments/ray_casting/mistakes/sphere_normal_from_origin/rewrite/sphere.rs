use pinhole::{Intersection, Ray, Sphere};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Sphere {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let unit = ray.direction.normalize();
        let scale = ray.direction.length();
        let nearest = (self.center - ray.origin).dot(unit);
        let beside = ray.origin + nearest * unit - self.center;
        let half = self.radius * self.radius - beside.length_squared();
        if half < 0.0 {
            return None;
        }
        let (first, second) = (nearest - half.sqrt(), nearest + half.sqrt());
        let t = if first / scale >= min_t {
            first / scale
        } else {
            second / scale
        };
        if t < min_t {
            return None;
        }
        let point = ray.origin + t * ray.direction;
        Some(Intersection {
            t,
            normal: point / point.length(),
        })
    }
}
