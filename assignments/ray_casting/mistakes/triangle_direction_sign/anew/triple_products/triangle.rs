use pinhole::{Intersection, Ray, Triangle};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Triangle {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let [a, b, c] = self.corners;
        let (t1, t2) = (b - a, c - a);
        let t2_cross_d = t2.cross(ray.direction);
        let determinant = t1.dot(t2_cross_d);
        if determinant == 0.0 {
            return None;
        }
        let left = ray.origin - a;
        let alpha = left.dot(t2_cross_d) / determinant;
        let d_cross_t1 = ray.direction.cross(t1);
        let beta = left.dot(d_cross_t1) / determinant;
        let t = t1.cross(t2).dot(left) / determinant;
        let inside = alpha >= 0.0 && beta >= 0.0 && alpha + beta <= 1.0;
        (inside && t >= min_t).then(|| Intersection {
            t,
            normal: t1.cross(t2).normalize(),
        })
    }
}
