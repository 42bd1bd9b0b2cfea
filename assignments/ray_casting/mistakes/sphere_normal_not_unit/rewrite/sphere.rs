use pinhole::{Intersection, Ray, Sphere};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Sphere {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let d = ray.direction.to_array();
        let f = (ray.origin - self.center).to_array();
        let mut a = 0.0;
        let mut b = 0.0;
        let mut c = -self.radius * self.radius;
        for axis in 0..3 {
            a += d[axis] * d[axis];
            b += 2.0 * d[axis] * f[axis];
            c += f[axis] * f[axis];
        }

        let discriminant = b * b - 4.0 * a * c;
        if discriminant < 0.0 {
            return None;
        }
        let t = [-1.0, 1.0]
            .map(|sign| (-b + sign * discriminant.sqrt()) / (2.0 * a))
            .into_iter()
            .find(|t| *t >= min_t)?;
        let normal = [0, 1, 2].map(|axis| f[axis] + t * d[axis]).into();
        Some(Intersection { t, normal })
    }
}
