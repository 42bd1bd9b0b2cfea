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
        if t <= 1.0 {
            return None;
        }
        let p = ray.at(t);
        let left_of = |from: DVec3, to: DVec3| (to - from).cross(p - from).dot(n) >= 0.0;
        let inside = left_of(a, b) && left_of(b, c) && left_of(c, a);
        inside.then(|| Intersection {
            t,
            normal: n.normalize(),
        })
    }
}
