use pinhole::{Intersection, Plane, Ray};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Plane {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        const PARALLEL: f64 = 1e-4;

        let n = self.normal;
        let k = n.dot(self.point);
        let rate = n.dot(ray.direction);
        if (-PARALLEL..PARALLEL).contains(&rate) {
            return None;
        }
        let t = (k - n.dot(ray.origin)) / rate;
        (t >= min_t).then(|| Intersection {
            t,
            normal: self.normal.normalize(),
        })
    }
}
