use pinhole::{Intersection, Ray, Sphere};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Sphere {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        // Work in the space in which this is the unit sphere around the origin.
        let origin = (ray.origin - self.center) / self.radius;
        let direction = ray.direction / self.radius;
        let a = direction.length_squared();
        let half_p = direction.dot(origin) / a;
        let q = (origin.length_squared() - 1.0) / a;
        let radicand = half_p * half_p - q;
        if radicand < 0.0 {
            return None;
        }
        let root = radicand.sqrt();
        [-root - half_p, root - half_p]
            .into_iter()
            .filter(|t| *t >= min_t)
            .reduce(f64::min)
            .map(|t| Intersection {
                t,
                normal: origin + t * direction,
            })
    }
}
