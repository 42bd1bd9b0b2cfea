use glam::DMat3;
use pinhole::{Intersection, Ray, Triangle};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Triangle {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let [p, q, r] = self.corners;
        let unit = ray.direction / ray.direction.length();
        let side1 = q - p;
        let side2 = r - p;
        let back = -unit;
        let rhs = ray.origin - p;
        let whole = DMat3::from_cols(side1, side2, back).determinant();
        if whole == 0.0 {
            return None;
        }
        let gamma_1 = DMat3::from_cols(rhs, side2, back).determinant() / whole;
        let gamma_2 = DMat3::from_cols(side1, rhs, back).determinant() / whole;
        let t = DMat3::from_cols(side1, side2, rhs).determinant() / whole;
        if gamma_1 >= 0.0 && gamma_2 >= 0.0 && gamma_1 + gamma_2 <= 1.0 && t >= min_t {
            Some(Intersection {
                t,
                normal: side1.cross(side2).normalize(),
            })
        } else {
            None
        }
    }
}
