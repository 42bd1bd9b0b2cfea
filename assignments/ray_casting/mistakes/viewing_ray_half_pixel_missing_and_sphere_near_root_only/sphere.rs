use pinhole::{Intersection, Ray, Sphere};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Sphere {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let from_center = ray.origin - self.center;
        let a = ray.direction.length_squared();
        let h = ray.direction.dot(from_center);
        let c = from_center.length_squared() - self.radius * self.radius;
        let discriminant = h * h - a * c;
        if discriminant < 0.0 {
            return None;
        }
        let t = (-h - discriminant.sqrt()) / a;
        (t >= min_t).then(|| Intersection {
            t,
            normal: (ray.at(t) - self.center) / self.radius,
        })
    }
}
