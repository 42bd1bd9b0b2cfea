use glam::DMat3;
use pinhole::{Intersection, Ray, Triangle};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Triangle {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let [a, b, c] = self.corners;
        let t1 = b - a;
        let t2 = c - a;
        let d = ray.direction;
        let matrix = DMat3::from_cols_array_2d(&[
            [t1.x, t2.x, -d.x],
            [t1.y, t2.y, -d.y],
            [t1.z, t2.z, -d.z],
        ]);
        if matrix.determinant() == 0.0 {
            return None;
        }
        let solution = matrix.inverse() * (ray.origin - a);
        let (alpha, beta, t) = (solution.x, solution.y, solution.z);
        if alpha < 0.0 || beta < 0.0 || alpha + beta > 1.0 || t < min_t {
            return None;
        }
        Some(Intersection {
            t,
            normal: t1.cross(t2).normalize(),
        })
    }
}
