use pinhole::{Intersection, Plane, Ray};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Plane {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let to_foot = -ray.origin.project_onto(self.normal);
        let approach = ray.direction.dot(to_foot);
        if approach == 0.0 {
            return None;
        }
        let t = to_foot.length_squared() / approach;
        if t < min_t {
            return None;
        }
        Some(Intersection {
            t,
            normal: self.normal.normalize(),
        })
    }
}
