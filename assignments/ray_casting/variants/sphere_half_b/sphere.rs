use pinhole::{Intersection, Ray, Sphere};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Sphere {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let Sphere { center, radius } = *self;
        let oc = center - ray.origin;
        let dd = ray.direction.length_squared();
        let half_b = ray.direction.dot(oc);
        let c = oc.length_squared() - radius * radius;
        let quarter_discriminant = half_b * half_b - dd * c;
        if quarter_discriminant < 0.0 {
            return None;
        }
        let q = half_b + half_b.signum() * quarter_discriminant.sqrt();
        let (mut near, mut far) = (c / q, q / dd);
        if near > far {
            std::mem::swap(&mut near, &mut far);
        }
        let t = if near >= min_t {
            near
        } else if far >= min_t {
            far
        } else {
            return None;
        };
        let p = ray.origin + ray.direction * t;
        Some(Intersection {
            t,
            normal: (p - center) / radius,
        })
    }
}
