use pinhole::{Intersection, Ray, Triangle};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Triangle {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let [a, b, c] = self.corners;
        let t1 = b;
        let t2 = c;
        let h = ray.direction.cross(t2);
        let det = t1.dot(h);
        if det == 0.0 {
            return None;
        }
        let s = ray.origin - a;
        let q = s.cross(t1);
        let alpha = s.dot(h) / det;
        let beta = ray.direction.dot(q) / det;
        let t = t2.dot(q) / det;
        if alpha < 0.0 || beta < 0.0 || alpha + beta > 1.0 || t < min_t {
            return None;
        }
        Some(Intersection {
            t,
            normal: t1.cross(t2).normalize(),
        })
    }
}
