use pinhole::{Intersection, Ray, Triangle};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Triangle {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let [a, b, c] = self.corners;
        let n = (b - a).cross(c - a);
        let along_normal = n.dot(ray.direction);
        if along_normal == 0.0 {
            return None;
        }
        let t = n.dot(a - ray.origin) / along_normal;
        if t < min_t {
            return None;
        }
        let p = ray.at(t);
        for (from, to) in [(a, b), (b, c), (c, a)] {
            let inward = n.cross(to - from);
            if inward.dot(p - from) < 0.0 {
                return None;
            }
        }
        Some(Intersection {
            t,
            normal: n.normalize(),
        })
    }
}
