use pinhole::{Intersection, Ray, Sphere};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Sphere {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        const TANGENT: f64 = 1e-5;

        let f = ray.origin - self.center;
        let a = ray.direction.length_squared();
        let h = ray.direction.dot(f);
        let discriminant = 4.0 * (h * h - a * (f.length_squared() - self.radius.powi(2)));
        if discriminant < -TANGENT {
            return None;
        }
        let middle = -h / a;
        let half = if discriminant <= TANGENT {
            0.0
        } else {
            discriminant.sqrt() / (2.0 * a)
        };
        let t = if middle - half >= min_t {
            middle - half
        } else {
            middle + half
        };
        if t < min_t {
            return None;
        }
        Some(Intersection {
            t,
            normal: (f + t * ray.direction).normalize(),
        })
    }
}
