use pinhole::{Intersection, Plane, Ray};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Plane {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let n = self.normal.normalize();
        let speed = ray.direction.length();
        let height = (self.point - ray.origin).dot(n);
        let cosine = ray.direction.dot(n) / speed;

        if cosine >= 0.0 {
            return None;
        }
        let distance = height / cosine;
        let t = distance / speed;
        if t < min_t {
            return None;
        }
        Some(Intersection { t, normal: n })
    }
}
