use pinhole::{Intersection, Ray, Sphere};

use crate::intersect_ray::IntersectRay;

/// A discriminant below this may be all rounding.
const EPSILON: f64 = 1e-5;

impl IntersectRay for Sphere {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let Ray { origin, direction } = *ray;
        let eye = origin - self.center;
        let a = direction.length_squared();
        let b = 2.0 * eye.dot(direction);
        let c = eye.length_squared() - self.radius.powi(2);

        let (near, far) = roots(a, b, c)?;
        let t = [near, far].into_iter().find(|t| *t >= min_t)?;
        Some(Intersection {
            t,
            normal: (ray.at(t) - self.center).normalize(),
        })
    }
}

/// The reliable solutions of a t² + b t + c = 0, the smaller first.
fn roots(a: f64, b: f64, c: f64) -> Option<(f64, f64)> {
    let discriminant = b * b - 4.0 * a * c;
    if discriminant < EPSILON {
        return None;
    }
    let root = discriminant.sqrt();
    Some(((-b - root) / (2.0 * a), (-b + root) / (2.0 * a)))
}
