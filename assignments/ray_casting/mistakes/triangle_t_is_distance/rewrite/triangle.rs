use glam::DVec3;
use pinhole::{Intersection, Ray, Triangle};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Triangle {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let [a, b, c] = self.corners;
        let n = (b - a).cross(c - a);
        let slope = n.dot(ray.direction);
        if slope == 0.0 {
            return None;
        }
        let t = n.dot(a - ray.origin) / slope;
        if t < min_t {
            return None;
        }
        let p = ray.origin + t * ray.direction;
        let weight =
            |from: DVec3, to: DVec3| (to - from).cross(p - from).dot(n) / n.length_squared();
        let (of_b, of_c) = (weight(c, a), weight(a, b));
        if of_b < 0.0 || of_c < 0.0 || of_b + of_c > 1.0 {
            return None;
        }
        Some(Intersection {
            t: (p - ray.origin).length(),
            normal: n.normalize(),
        })
    }
}
