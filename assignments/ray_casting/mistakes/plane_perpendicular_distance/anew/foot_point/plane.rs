use pinhole::{Intersection, Plane, Ray};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Plane {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let parallel = ray.direction.dot(self.normal) == 0.0;
        let to_foot = (self.point - ray.origin).project_onto(self.normal);
        let t = to_foot.length();
        (!parallel && t >= min_t).then(|| Intersection {
            t,
            normal: self.normal.normalize(),
        })
    }
}
