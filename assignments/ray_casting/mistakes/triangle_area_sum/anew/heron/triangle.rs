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
        let p = ray.at(t);
        let difference = heron(p, a, b) + heron(p, b, c) + heron(p, c, a) - heron(a, b, c);
        (difference.abs() <= 1e-3 && t >= min_t).then(|| Intersection {
            t,
            normal: n.normalize(),
        })
    }
}

fn heron(a: DVec3, b: DVec3, c: DVec3) -> f64 {
    let [x, y, z] = [b.distance(c), c.distance(a), a.distance(b)];
    let s = (x + y + z) / 2.0;
    (s * (s - x) * (s - y) * (s - z)).max(0.0).sqrt()
}
