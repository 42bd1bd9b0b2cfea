use pinhole::{Intersection, Ray, Sphere};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Sphere {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let e = (ray.origin - self.center) / self.radius;
        let d = ray.direction / self.radius;
        let dd = d.dot(d);
        let de = d.dot(e);
        let behind = de > 0.0;
        let under_root = de * de - dd * (e.dot(e) - 1.0);
        if behind || under_root < 0.0 {
            return None;
        }
        let reach = under_root.sqrt();
        let [first, second] = [-reach, reach].map(|side| (side - de) / dd);

        [first, second]
            .into_iter()
            .find(|t| *t >= min_t)
            .map(|t| Intersection {
                t,
                normal: e + t * d,
            })
    }
}
