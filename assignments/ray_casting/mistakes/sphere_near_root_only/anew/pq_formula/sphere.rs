use pinhole::{Intersection, Ray, Sphere};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Sphere {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let v = ray.origin - self.center;
        let dd = ray.direction.dot(ray.direction);
        let p = 2.0 * v.dot(ray.direction) / dd;
        let q = (v.dot(v) - self.radius.powi(2)) / dd;
        let inner = (p / 2.0).powi(2) - q;
        if inner < 0.0 {
            return None;
        }
        let near = -p / 2.0 - inner.sqrt();
        if near < min_t {
            return None;
        }
        let outward = v + near * ray.direction;
        Some(Intersection {
            t: near,
            normal: outward / outward.length(),
        })
    }
}
