use pinhole::{Intersection, Ray, Sphere};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Sphere {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let to_eye = ray.origin - self.center;
        let a = ray.direction.length_squared();
        let h = ray.direction.dot(to_eye);
        let discriminant = h * h - a * (to_eye.length_squared() - self.radius * self.radius);
        if discriminant < 0.0 {
            return None;
        }
        let root = discriminant.sqrt();
        let t = [(-h - root) / a, (-h + root) / a]
            .into_iter()
            .find(|t| *t >= min_t)?;
        let normal = ray.at(t).normalize();
        Some(Intersection { t, normal })
    }
}
