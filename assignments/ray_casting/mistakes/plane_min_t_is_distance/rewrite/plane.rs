use pinhole::{Intersection, Plane, Ray};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Plane {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let plane = self.normal.extend(-self.normal.dot(self.point));
        let at_eye = plane.dot(ray.origin.extend(1.0));
        let per_t = plane.dot(ray.direction.extend(0.0));

        let nearest = min_t / ray.direction.length();
        let t = -at_eye / per_t;
        (per_t != 0.0 && t >= nearest).then(|| Intersection {
            t,
            normal: self.normal.normalize(),
        })
    }
}
