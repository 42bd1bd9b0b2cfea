use pinhole::{Intersection, Ray, Sphere};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Sphere {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let Sphere { center, radius } = *self;
        let oc = center - ray.origin;
        let dd = ray.direction.length_squared();
        let half_b = ray.direction.dot(oc);
        let c = oc.length_squared() - radius * radius;
        let quarter = half_b * half_b - dd * c;
        if quarter < 0.0 {
            return None;
        }
        let q = half_b + half_b.signum() * quarter.sqrt();
        let near = (c / q).min(q / dd);
        let far = (c / q).max(q / dd);

        let eye_outside = near > 0.0;
        let t = if eye_outside { near } else { far };
        if t < min_t {
            return None;
        }
        Some(Intersection {
            t,
            normal: (ray.at(t) - center) / radius,
        })
    }
}
