use glam::DMat3;
use pinhole::{Intersection, Ray, Triangle};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Triangle {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let [a, b, c] = self.corners;
        let t1 = b - a;
        let t2 = c - a;
        let rows = DMat3::from_cols(t1, t2, -ray.direction).transpose();
        let det = rows.determinant();
        if det == 0.0 {
            return None;
        }
        let e = ray.origin - a;
        let alpha = DMat3::from_cols(e, rows.y_axis, rows.z_axis).determinant() / det;
        let beta = DMat3::from_cols(rows.x_axis, e, rows.z_axis).determinant() / det;
        if alpha.min(beta) < 0.0 || alpha + beta > 1.0 {
            return None;
        }
        let t = DMat3::from_cols(rows.x_axis, rows.y_axis, e).determinant() / det;
        if t < min_t {
            return None;
        }
        Some(Intersection {
            t,
            normal: t1.cross(t2).normalize(),
        })
    }
}
