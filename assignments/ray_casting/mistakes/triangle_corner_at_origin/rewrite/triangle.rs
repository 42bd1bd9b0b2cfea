use pinhole::{Intersection, Ray, Triangle};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Triangle {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let [a, b, c] = self.corners;
        let (t1, t2) = (b - a, c - a);
        let n = t1.cross(t2);
        let approach = n.dot(ray.direction);
        if approach == 0.0 {
            return None;
        }
        let start = ray.origin;
        let t = n.dot(-start) / approach;
        let on_plane = start + ray.direction * t;
        let (dual1, dual2) = (t2.cross(n), n.cross(t1));
        let alpha = on_plane.dot(dual1) / t1.dot(dual1);
        let beta = on_plane.dot(dual2) / t2.dot(dual2);
        (alpha >= 0.0 && beta >= 0.0 && alpha + beta <= 1.0 && t >= min_t).then(|| Intersection {
            t,
            normal: n.normalize(),
        })
    }
}
