use pinhole::{Intersection, Ray, Sphere};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Sphere {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let oc = self.center - ray.origin;
        let half_b = ray.direction.dot(oc);
        let c = oc.length_squared() - self.radius * self.radius;
        let quarter = half_b * half_b - c;
        if quarter < 0.0 {
            return None;
        }
        let q = half_b + half_b.signum() * quarter.sqrt();
        let [near, far] = if q < c / q { [q, c / q] } else { [c / q, q] };
        if far < min_t {
            return None;
        }
        let t = if near >= min_t { near } else { far };
        Some(Intersection {
            t,
            normal: (ray.at(t) - self.center).normalize(),
        })
    }
}
