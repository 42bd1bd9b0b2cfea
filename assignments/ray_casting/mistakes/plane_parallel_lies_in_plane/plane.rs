use pinhole::{Intersection, Plane, Ray};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Plane {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let normal = self.normal.normalize();
        let along_normal = ray.direction.dot(self.normal);
        if along_normal == 0.0 {
            return Some(Intersection { t: min_t, normal });
        }
        let t = (self.point - ray.origin).dot(self.normal) / along_normal;
        (t >= min_t).then_some(Intersection { t, normal })
    }
}
