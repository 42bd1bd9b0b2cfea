use pinhole::{Intersection, Ray, Sphere};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Sphere {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let offset = ray.origin - self.center;
        let qa = ray.direction.dot(ray.direction);
        let qb = 2.0 * ray.direction.dot(offset);
        let qc = offset.dot(offset) - self.radius.powi(2);
        let disc = qb.powi(2) - 4.0 * qa * qc;

        let mut answer = None;
        if disc >= 0.0 {
            for sign in [1.0, -1.0] {
                let t = (-qb + sign * disc.sqrt()) / (2.0 * qa);
                if t >= min_t {
                    let normal = (ray.at(t) - self.center).normalize();
                    answer = Some(Intersection { t, normal });
                }
            }
        }
        answer
    }
}
