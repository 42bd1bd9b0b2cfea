use pinhole::{Intersection, Plane, Ray};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Plane {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let n = self.normal.normalize();
        let cosine = n.dot(ray.direction);
        if cosine == 0.0 {
            return None;
        }
        let t = n.dot(self.point - ray.origin) / cosine;
        if t < min_t {
            return None;
        }
        let normal = if cosine < 0.0 { n } else { -n };
        Some(Intersection { t, normal })
    }
}
