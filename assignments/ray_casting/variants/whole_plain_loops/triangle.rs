use glam::DVec3;
use pinhole::{Intersection, Ray, Triangle};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Triangle {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let [a, b, c] = self.corners;
        let normal = (b - a).cross(c - a).normalize();
        let climb = ray.direction.dot(normal);
        if climb == 0.0 {
            return None;
        }
        let t = (a - ray.origin).dot(normal) / climb;
        if t < min_t {
            return None;
        }

        // The point must lie on the inner side of each edge, as seen against the normal.
        let from_a = ray.origin - a + t * ray.direction;
        let corners = [DVec3::ZERO, b - a, c - a];
        for k in 0..3 {
            let (from, to) = (corners[k], corners[(k + 1) % 3]);
            if (to - from).cross(from_a - from).dot(normal) < 0.0 {
                return None;
            }
        }
        Some(Intersection { t, normal })
    }
}
