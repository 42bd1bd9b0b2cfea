use pinhole::{Intersection, Ray, Sphere};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Sphere {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let to_center = self.center - ray.origin;
        let speed_squared = ray.direction.length_squared();
        let offset_squared = to_center.cross(ray.direction).length_squared() / speed_squared;
        let depth_squared = self.radius.powi(2) - offset_squared;
        if depth_squared < 0.0 {
            return None;
        }
        let middle = to_center.dot(ray.direction) / speed_squared;
        let half = (depth_squared / speed_squared).sqrt();
        let t = match middle + half {
            far if far >= min_t => far,
            _ if middle - half >= min_t => middle - half,
            _ => return None,
        };
        Some(Intersection {
            t,
            normal: (ray.at(t) - self.center).normalize(),
        })
    }
}
