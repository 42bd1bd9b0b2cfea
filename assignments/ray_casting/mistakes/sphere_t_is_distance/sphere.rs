use pinhole::{Intersection, Ray, Sphere};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Sphere {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let direction = ray.direction.normalize();
        let to_eye = ray.origin - self.center;
        let b = 2.0 * direction.dot(to_eye);
        let c = to_eye.dot(to_eye) - self.radius * self.radius;
        let discriminant = b * b - 4.0 * c;
        if discriminant < 0.0 {
            return None;
        }
        let near = (-b - discriminant.sqrt()) / 2.0;
        let far = (-b + discriminant.sqrt()) / 2.0;
        let t = if near >= min_t { near } else { far };
        if t < min_t {
            return None;
        }
        let p = ray.origin + t * direction;
        Some(Intersection {
            t,
            normal: (p - self.center) / self.radius,
        })
    }
}
