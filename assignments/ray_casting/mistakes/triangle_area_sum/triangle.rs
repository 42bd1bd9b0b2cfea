use glam::DVec3;
use pinhole::{Intersection, Ray, Triangle};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Triangle {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let [a, b, c] = self.corners;
        let normal = (b - a).cross(c - a).normalize();
        let denominator = ray.direction.dot(normal);
        if denominator == 0.0 {
            return None;
        }
        let t = (a - ray.origin).dot(normal) / denominator;
        if t < min_t {
            return None;
        }
        let p = ray.at(t);
        let whole = area(a, b, c);
        let parts = area(p, a, b) + area(p, b, c) + area(p, c, a);
        if (parts - whole).abs() > 1e-3 {
            return None;
        }
        Some(Intersection { t, normal })
    }
}

fn area(a: DVec3, b: DVec3, c: DVec3) -> f64 {
    (b - a).cross(c - a).length() / 2.0
}
