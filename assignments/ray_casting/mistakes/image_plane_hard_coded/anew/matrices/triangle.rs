use glam::DMat3;
use pinhole::{Intersection, Ray, Triangle};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Triangle {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let [a, b, c] = self.corners;
        let system = DMat3::from_cols(b - a, c - a, -ray.direction);
        if system.determinant() == 0.0 {
            return None;
        }
        let [alpha, beta, t] = (system.inverse() * (ray.origin - a)).to_array();
        let inside = alpha >= 0.0 && beta >= 0.0 && alpha + beta <= 1.0;
        (inside && t > 1.0).then(|| Intersection {
            t,
            normal: (b - a).cross(c - a).normalize(),
        })
    }
}
