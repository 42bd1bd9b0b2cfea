use pinhole::{Intersection, Plane, Ray};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Plane {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let n = self.normal;
        let k = n.dot(self.point);
        let rate = n.dot(ray.direction);
        let t = if rate == 0.0 {
            min_t
        } else {
            (k - n.dot(ray.origin)) / rate
        };
        (t >= min_t).then(|| Intersection {
            t,
            normal: self.normal.normalize(),
        })
    }
}
