use pinhole::{Intersection, Ray, Triangle};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Triangle {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let [a, b, c] = self.corners;
        let normal = (b - a).cross(c - a).normalize();
        let along_normal = ray.direction.dot(normal);
        if along_normal == 0.0 {
            return None;
        }
        let t = (a - ray.origin).dot(normal) / along_normal;
        if t < min_t {
            return None;
        }
        Some(Intersection { t, normal })
    }
}
