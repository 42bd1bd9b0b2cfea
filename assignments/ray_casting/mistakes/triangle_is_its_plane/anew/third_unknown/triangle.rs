use glam::DMat3;
use pinhole::{Intersection, Ray, Triangle};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Triangle {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let [a, b, c] = self.corners;
        let t1 = b - a;
        let t2 = c - a;
        let determinant = DMat3::from_cols(t1, t2, -ray.direction).determinant();
        let t = DMat3::from_cols(t1, t2, ray.origin - a).determinant() / determinant;
        if determinant != 0.0 && t >= min_t {
            Some(Intersection {
                t,
                normal: t1.cross(t2).normalize(),
            })
        } else {
            None
        }
    }
}
