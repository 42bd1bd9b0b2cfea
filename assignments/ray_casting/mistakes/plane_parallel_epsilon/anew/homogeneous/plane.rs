use pinhole::{Intersection, Plane, Ray};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Plane {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let plane = self.normal.extend(-self.normal.dot(self.point));
        let at_eye = plane.dot(ray.origin.extend(1.0));
        let per_t = plane.dot(ray.direction.extend(0.0));

        let parallel = per_t.abs() < 1e-4;
        let t = -at_eye / per_t;
        if parallel || t < min_t {
            return None;
        }
        Some(Intersection {
            t,
            normal: self.normal.normalize(),
        })
    }
}
