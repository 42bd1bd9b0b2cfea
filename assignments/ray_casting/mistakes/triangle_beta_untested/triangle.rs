use pinhole::{Intersection, Ray, Triangle};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Triangle {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let [a, b, c] = self.corners;
        let (t1, t2) = (b - a, c - a);
        let to_eye = ray.origin - a;
        let across = ray.direction.cross(t2);
        let determinant = t1.dot(across);
        if determinant == 0.0 {
            return None;
        }
        let alpha = to_eye.dot(across) / determinant;
        if !(0.0..=1.0).contains(&alpha) {
            return None;
        }
        let around = to_eye.cross(t1);
        let beta = ray.direction.dot(around) / determinant;
        if alpha + beta > 1.0 {
            return None;
        }
        let t = t2.dot(around) / determinant;
        (t >= min_t).then(|| Intersection {
            t,
            normal: t1.cross(t2).normalize(),
        })
    }
}
