use glam::DMat3;
use pinhole::{Intersection, Ray, Triangle};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Triangle {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let [a, b, c] = self.corners;
        let t1 = b - a;
        let t2 = c - a;
        let matrix = DMat3::from_cols(t1, t2, ray.direction);
        if matrix.determinant() == 0.0 {
            return None;
        }
        let [alpha, beta, t] = (matrix.inverse() * (ray.origin - a)).to_array();
        if alpha < 0.0 || beta < 0.0 || alpha + beta > 1.0 || t < min_t {
            return None;
        }
        Some(Intersection {
            t,
            normal: t1.cross(t2).normalize(),
        })
    }
}
