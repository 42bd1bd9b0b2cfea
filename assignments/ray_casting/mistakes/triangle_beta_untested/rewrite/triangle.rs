use pinhole::{Intersection, Ray, Triangle};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Triangle {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let [a, b, c] = self.corners;
        let normal = (b - a).cross(c - a);
        let approach = normal.dot(ray.direction);
        if approach == 0.0 {
            return None;
        }
        let t = normal.dot(a - ray.origin) / approach;
        if t < min_t {
            return None;
        }
        let p = ray.at(t);
        let area = normal.length_squared();
        let alpha = (p - a).cross(c - a).dot(normal) / area;
        let opposite_a = (b - p).cross(c - p).dot(normal) / area;
        if alpha < 0.0 || alpha > 1.0 || opposite_a < 0.0 {
            return None;
        }
        Some(Intersection {
            t,
            normal: normal.normalize(),
        })
    }
}
