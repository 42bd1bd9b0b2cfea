use pinhole::{Intersection, Ray, Triangle};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Triangle {
    fn intersect_ray(&self, ray: &Ray, _min_t: f64) -> Option<Intersection> {
        let [a, b, c] = self.corners;
        let (t1, t2) = (b - a, c - a);
        let h = ray.direction.cross(t2);
        let determinant = t1.dot(h);
        if determinant == 0.0 {
            return None;
        }
        let s = ray.origin - a;
        let q = s.cross(t1);
        let alpha = s.dot(h) / determinant;
        let beta = ray.direction.dot(q) / determinant;
        if alpha < 0.0 || beta < 0.0 || alpha + beta > 1.0 {
            return None;
        }
        Some(Intersection {
            t: t2.dot(q) / determinant,
            normal: t1.cross(t2).normalize(),
        })
    }
}
