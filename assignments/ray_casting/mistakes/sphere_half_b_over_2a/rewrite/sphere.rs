use pinhole::{Intersection, Ray, Sphere};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Sphere {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let Ray { origin, direction } = *ray;
        let eye = origin - self.center;
        let a = direction.length_squared();
        let b = eye.dot(direction);
        let c = eye.length_squared() - self.radius.powi(2);

        let (near, far) = roots(a, b, c)?;
        let t = if near >= min_t { near } else { far };
        if t < min_t {
            return None;
        }
        Some(Intersection {
            t,
            normal: (ray.at(t) - self.center).normalize(),
        })
    }
}

/// The real solutions of a t² + 2 b t + c = 0, the smaller first.
fn roots(a: f64, b: f64, c: f64) -> Option<(f64, f64)> {
    let discriminant = b * b - a * c;
    if discriminant < 0.0 {
        return None;
    }
    let root = discriminant.sqrt();
    Some(((-b - root) / (2.0 * a), (-b + root) / (2.0 * a)))
}
