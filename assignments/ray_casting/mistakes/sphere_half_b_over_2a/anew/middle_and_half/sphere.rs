use pinhole::{Intersection, Ray, Sphere};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Sphere {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let from_center = ray.origin - self.center;
        let a = ray.direction.length_squared();
        let h = from_center.dot(ray.direction);
        let c = from_center.length_squared() - self.radius.powi(2);
        let discriminant = h.powi(2) - a * c;
        if discriminant < 0.0 {
            return None;
        }
        let middle = -h / (2.0 * a);
        let half = discriminant.sqrt() / (2.0 * a);
        let t = if middle - half >= min_t {
            middle - half
        } else {
            middle + half
        };
        (t >= min_t).then(|| Intersection {
            t,
            normal: (from_center + t * ray.direction).normalize(),
        })
    }
}
