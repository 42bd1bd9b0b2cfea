use pinhole::{Intersection, Ray, Sphere};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Sphere {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let Ray { origin, direction } = *ray;
        let eye = origin - self.center;
        let a = direction.length_squared();
        let b = 2.0 * eye.dot(direction);
        let c = eye.length_squared() - self.radius.powi(2);

        let t = roots(a, b, c).into_iter().find(|t| *t >= min_t)?;
        Some(Intersection {
            t,
            normal: (ray.at(t) - self.center).normalize(),
        })
    }
}

/// The solutions of a t² + b t + c = 0 in increasing order: none, one or two.
fn roots(a: f64, b: f64, c: f64) -> Vec<f64> {
    let discriminant = b * b - 4.0 * a * c;
    if discriminant > 1e-5 {
        let root = discriminant.sqrt();
        vec![(-b - root) / (2.0 * a), (-b + root) / (2.0 * a)]
    } else if discriminant >= -1e-5 {
        vec![-b / (2.0 * a)]
    } else {
        vec![]
    }
}
