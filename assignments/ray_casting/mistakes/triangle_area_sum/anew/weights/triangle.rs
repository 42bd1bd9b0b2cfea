use pinhole::{Intersection, Ray, Triangle};

use crate::intersect_ray::IntersectRay;

const SLACK: f64 = 1e-3;

impl IntersectRay for Triangle {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let [a, b, c] = self.corners;
        let (t1, t2) = (b - a, c - a);
        let h = ray.direction.cross(t2);
        let det = t1.dot(h);
        if det == 0.0 {
            return None;
        }
        let s = ray.origin - a;
        let q = s.cross(t1);
        let (beta, gamma) = (s.dot(h) / det, ray.direction.dot(q) / det);
        let t = t2.dot(q) / det;
        if t < min_t {
            return None;
        }
        let n = t1.cross(t2);
        let area = 0.5 * n.length();
        let parts: f64 = [1.0 - beta - gamma, beta, gamma]
            .iter()
            .map(|weight| weight.abs() * area)
            .sum();
        if parts - area > SLACK {
            return None;
        }
        Some(Intersection {
            t,
            normal: n.normalize(),
        })
    }
}
