use pinhole::{Intersection, Ray, Sphere};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Sphere {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let from_center = ray.origin - self.center;
        let h = ray.direction.dot(from_center);
        let c = from_center.length_squared() - self.radius * self.radius;
        let discriminant = h * h - c;
        if discriminant < 0.0 {
            return None;
        }
        let t = [-h - discriminant.sqrt(), -h + discriminant.sqrt()]
            .into_iter()
            .find(|t| *t >= min_t)?;
        Some(Intersection {
            t,
            normal: (ray.at(t) - self.center).normalize(),
        })
    }
}
