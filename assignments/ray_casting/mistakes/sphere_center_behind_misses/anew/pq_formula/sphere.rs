use pinhole::{Intersection, Ray, Sphere};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Sphere {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let v = ray.origin - self.center;
        let dd = ray.direction.dot(ray.direction);
        let p = 2.0 * v.dot(ray.direction) / dd;
        if p > 0.0 {
            return None;
        }
        let q = (v.dot(v) - self.radius.powi(2)) / dd;
        let inner = (p / 2.0).powi(2) - q;
        if inner < 0.0 {
            return None;
        }

        let root = inner.sqrt();
        let (t1, t2) = (-p / 2.0 - root, -p / 2.0 + root);
        if t2 < min_t {
            return None;
        }
        let t = if t1 < min_t { t2 } else { t1 };
        Some(Intersection {
            t,
            normal: (ray.at(t) - self.center) / self.radius,
        })
    }
}
