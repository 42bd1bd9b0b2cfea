use pinhole::{Intersection, Plane, Ray};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Plane {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let n = self.normal;
        let k = n.dot(self.point);
        let rate = n.dot(ray.direction);
        if rate == 0.0 {
            return None;
        }
        let t = (k - n.dot(ray.origin)) / rate;

        let p = ray.at(t);
        let in_view = t >= 0.0 && p.distance(ray.origin) >= min_t;
        in_view.then(|| Intersection {
            t,
            normal: n.normalize(),
        })
    }
}
