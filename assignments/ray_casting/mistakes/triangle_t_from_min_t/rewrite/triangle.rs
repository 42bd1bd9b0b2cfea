use pinhole::{Intersection, Ray, Triangle};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Triangle {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let [a, b, c] = self.corners;
        let e1 = b - a;
        let e2 = c - a;
        let n = e1.cross(e2);
        let slope = ray.direction.dot(n);
        if slope == 0.0 {
            return None;
        }
        let to_eye = ray.origin - a;
        let t = -to_eye.dot(n) / slope;
        if t < min_t {
            return None;
        }
        let p = to_eye + t * ray.direction;
        let (d11, d12, d22) = (e1.dot(e1), e1.dot(e2), e2.dot(e2));
        let (p1, p2) = (p.dot(e1), p.dot(e2));
        let whole = d11 * d22 - d12 * d12;
        let v = (d22 * p1 - d12 * p2) / whole;
        let w = (d11 * p2 - d12 * p1) / whole;
        if v < 0.0 || w < 0.0 || v + w > 1.0 {
            return None;
        }
        Some(Intersection {
            t: t - min_t,
            normal: n.normalize(),
        })
    }
}
