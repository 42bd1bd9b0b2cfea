//! Given code, which you may replace with your `triangle.rs` of the first assignment.

use pinhole::{Intersection, Ray, Triangle};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Triangle {
    /// Where a ray meets a triangle, edges included: e + t d = a + β (b − a) + γ (c − a), solved
    /// by Cramer's rule.
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let [a, b, c] = self.corners;
        let (to_b, to_c, to_eye) = (b - a, c - a, ray.origin - a);
        let normal = to_b.cross(to_c);
        let determinant = -ray.direction.dot(normal);
        if determinant == 0.0 {
            return None;
        }
        let across = to_eye.cross(ray.direction);
        let beta = to_c.dot(across) / determinant;
        let gamma = -to_b.dot(across) / determinant;
        let t = to_eye.dot(normal) / determinant;
        let is_inside = beta >= 0.0 && gamma >= 0.0 && beta + gamma <= 1.0;
        (is_inside && t >= min_t).then(|| Intersection {
            t,
            normal: normal.normalize(),
        })
    }
}
