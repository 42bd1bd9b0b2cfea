use pinhole::{Intersection, Plane, Ray};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Plane {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let d = ray.direction.normalize();
        let n = self.normal.normalize();
        let cosine = d.dot(n);
        if cosine == 0.0 {
            return None;
        }
        let t = (self.point - ray.origin).dot(n) / cosine;
        (t >= min_t).then_some(Intersection { t, normal: n })
    }
}
