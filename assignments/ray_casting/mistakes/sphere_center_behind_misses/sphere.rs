use pinhole::{Intersection, Ray, Sphere};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Sphere {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let to_center = self.center - ray.origin;
        let along = to_center.dot(ray.direction);
        if along < 0.0 {
            return None;
        }
        let a = ray.direction.length_squared();
        let c = to_center.length_squared() - self.radius * self.radius;
        let discriminant = along * along - a * c;
        if discriminant < 0.0 {
            return None;
        }
        let root = discriminant.sqrt();
        let t = [(along - root) / a, (along + root) / a]
            .into_iter()
            .find(|t| *t >= min_t)?;
        Some(Intersection {
            t,
            normal: (ray.at(t) - self.center).normalize(),
        })
    }
}
