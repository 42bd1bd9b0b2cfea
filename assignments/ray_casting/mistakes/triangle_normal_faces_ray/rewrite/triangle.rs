use glam::DMat3;
use pinhole::{Intersection, Ray, Triangle};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Triangle {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let [a, b, c] = self.corners;
        let (t1, t2) = (b - a, c - a);
        let system = DMat3::from_cols(t1, t2, -ray.direction);
        if system.determinant() == 0.0 {
            return None;
        }
        let [alpha, beta, t] = (system.inverse() * (ray.origin - a)).to_array();
        if !(alpha >= 0.0 && beta >= 0.0 && alpha + beta <= 1.0 && t >= min_t) {
            return None;
        }
        let mut normal = t1.cross(t2).normalize();
        if normal.dot(ray.direction) > 0.0 {
            normal = -normal;
        }
        Some(Intersection { t, normal })
    }
}
