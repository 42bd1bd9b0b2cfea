use glam::Mat3;
use pinhole::{Intersection, Ray, Triangle};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Triangle {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let [a, b, c] = self.corners;
        let t1 = b - a;
        let t2 = c - a;
        let matrix = Mat3::from_cols(t1.as_vec3(), t2.as_vec3(), -ray.direction.as_vec3());
        let solution = matrix.inverse() * (ray.origin - a).as_vec3();
        let (alpha, beta, t) = (solution.x, solution.y, f64::from(solution.z));
        if alpha >= 0.0 && beta >= 0.0 && alpha + beta <= 1.0 && t >= min_t {
            Some(Intersection {
                t,
                normal: t1.cross(t2).normalize(),
            })
        } else {
            None
        }
    }
}
