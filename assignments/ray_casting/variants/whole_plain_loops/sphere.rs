use pinhole::{Intersection, Ray, Sphere};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Sphere {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let (mut a, mut b, mut c) = (0.0, 0.0, -(self.radius * self.radius));
        for k in 0..3 {
            let d = ray.direction[k];
            let e = ray.origin[k] - self.center[k];
            a += d * d;
            b += 2.0 * d * e;
            c += e * e;
        }
        let discriminant = b * b - 4.0 * a * c;
        if discriminant < 0.0 {
            return None;
        }

        let mut t = (-b - discriminant.sqrt()) / (2.0 * a);
        if t < min_t {
            t = (-b + discriminant.sqrt()) / (2.0 * a);
        }
        if t < min_t {
            return None;
        }
        let normal = (ray.at(t) - self.center).normalize();
        Some(Intersection { t, normal })
    }
}
