use pinhole::{Intersection, Plane, Ray};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Plane {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let normal = self.normal.normalize();
        let cosine = normal.dot(ray.direction);
        if cosine == 0.0 {
            return None;
        }
        let t = (self.point - ray.origin).dot(self.normal) / cosine;
        if t < min_t {
            return None;
        }
        Some(Intersection { t, normal })
    }
}
