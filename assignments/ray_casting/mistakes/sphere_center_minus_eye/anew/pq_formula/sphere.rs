use pinhole::{Intersection, Ray, Sphere};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Sphere {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let v = self.center - ray.origin;
        let dd = ray.direction.dot(ray.direction);
        let p = 2.0 * v.dot(ray.direction) / dd;
        let q = (v.dot(v) - self.radius.powi(2)) / dd;
        let inner = (p / 2.0).powi(2) - q;
        if inner < 0.0 {
            return None;
        }

        let t = [-inner.sqrt(), inner.sqrt()]
            .map(|side| -p / 2.0 + side)
            .into_iter()
            .find(|t| *t >= min_t)?;
        Some(Intersection {
            t,
            normal: (ray.at(t) - self.center).normalize(),
        })
    }
}
