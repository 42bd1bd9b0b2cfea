use pinhole::{Intersection, Plane, Ray};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Plane {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let start = self.point - ray.at(min_t);
        let n = self.normal;
        let ahead = start.x.mul_add(n.x, start.y.mul_add(n.y, start.z * n.z));
        let per_t = ray
            .direction
            .x
            .mul_add(n.x, ray.direction.y.mul_add(n.y, ray.direction.z * n.z));
        if per_t == 0.0 || ahead * per_t < 0.0 {
            return None;
        }
        Some(Intersection {
            t: min_t + ahead / per_t,
            normal: n / n.length(),
        })
    }
}
