use pinhole::{Intersection, Ray, Sphere};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Sphere {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let Ray { origin, direction } = *ray;
        let eye = origin - self.center;
        let a = direction.length_squared();
        let b = 2.0 * eye.dot(direction);
        let c = eye.length_squared() - self.radius.powi(2);

        let t = match roots(a, b, c)[..] {
            [touching] => touching,
            [near, _] if near >= min_t => near,
            [_, far] if far >= min_t => far,
            _ => return None,
        };
        Some(Intersection {
            t,
            normal: (ray.at(t) - self.center).normalize(),
        })
    }
}

/// The solutions of a t² + b t + c = 0 in increasing order: none, one or two.
fn roots(a: f64, b: f64, c: f64) -> Vec<f64> {
    let discriminant = b * b - 4.0 * a * c;
    if discriminant < -1e-5 {
        Vec::new()
    } else if discriminant < 1e-5 {
        vec![-b / (2.0 * a)]
    } else {
        [-1.0, 1.0]
            .map(|sign| (-b + sign * discriminant.sqrt()) / (2.0 * a))
            .to_vec()
    }
}
