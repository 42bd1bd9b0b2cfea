use pinhole::{Intersection, Ray, Sphere};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Sphere {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let d = ray.direction.to_array();
        let f = (ray.origin - self.center).to_array();
        let b: f64 = (0..3).map(|axis| 2.0 * d[axis] * f[axis]).sum();
        let c = f.iter().map(|x| x * x).sum::<f64>() - self.radius * self.radius;
        let discriminant = b * b - 4.0 * c;
        if discriminant < 0.0 {
            return None;
        }
        [-1.0, 1.0]
            .into_iter()
            .map(|sign| (-b + sign * discriminant.sqrt()) / 2.0)
            .find(|t| *t >= min_t)
            .map(|t| Intersection {
                t,
                normal: (ray.at(t) - self.center).normalize(),
            })
    }
}
