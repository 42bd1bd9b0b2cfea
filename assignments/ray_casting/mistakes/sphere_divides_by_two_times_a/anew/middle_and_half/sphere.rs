use pinhole::{Intersection, Ray, Sphere};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Sphere {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let f = ray.origin - self.center;
        let a = ray.direction.length_squared();
        let b = 2.0 * ray.direction.dot(f);
        let discriminant = b.powi(2) - 4.0 * a * (f.length_squared() - self.radius.powi(2));
        if discriminant < 0.0 {
            return None;
        }
        let middle = -b / 2.0 * a;
        let half = discriminant.sqrt() / 2.0 * a;
        let t = if middle - half >= min_t {
            middle - half
        } else {
            middle + half
        };
        (t >= min_t).then(|| Intersection {
            t,
            normal: (f + t * ray.direction).normalize(),
        })
    }
}
