use pinhole::{Intersection, Plane, Ray};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Plane {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let along_normal = ray.direction.dot(self.normal);
        if along_normal >= 0.0 {
            return None;
        }
        let t = (self.point - ray.origin).dot(self.normal) / along_normal;
        (t >= min_t).then(|| Intersection {
            t,
            normal: self.normal.normalize(),
        })
    }
}
