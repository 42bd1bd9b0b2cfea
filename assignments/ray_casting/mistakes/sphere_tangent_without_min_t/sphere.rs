use pinhole::{Intersection, Ray, Sphere};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Sphere {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let normal_at = |t| (ray.at(t) - self.center).normalize();
        let to_eye = ray.origin - self.center;
        let a = ray.direction.dot(ray.direction);
        let b = 2.0 * ray.direction.dot(to_eye);
        let c = to_eye.dot(to_eye) - self.radius * self.radius;
        let discriminant = b * b - 4.0 * a * c;
        if discriminant < -1e-5 {
            return None;
        }
        if discriminant < 1e-5 {
            let t = -b / (2.0 * a);
            return Some(Intersection {
                t,
                normal: normal_at(t),
            });
        }
        for t in [
            (-b - discriminant.sqrt()) / (2.0 * a),
            (-b + discriminant.sqrt()) / (2.0 * a),
        ] {
            if t >= min_t {
                return Some(Intersection {
                    t,
                    normal: normal_at(t),
                });
            }
        }
        None
    }
}
