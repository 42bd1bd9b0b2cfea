use pinhole::{Intersection, Ray, Sphere};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Sphere {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let start = ray.at(min_t);
        let to_center = self.center - start;
        let towards = to_center.dot(ray.direction);
        let outside = to_center.length_squared() - self.radius * self.radius;
        if outside > 0.0 && towards < 0.0 {
            return None;
        }
        let a = ray.direction.length_squared();
        let quarter = towards * towards - a * outside;
        if quarter < 0.0 {
            return None;
        }
        let root = if outside > 0.0 {
            -quarter.sqrt()
        } else {
            quarter.sqrt()
        };
        let t = min_t + (towards + root) / a;
        Some(Intersection {
            t,
            normal: (ray.at(t) - self.center).normalize(),
        })
    }
}
