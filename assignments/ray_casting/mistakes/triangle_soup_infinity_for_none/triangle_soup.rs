use glam::DVec3;
use pinhole::{Intersection, Ray, TriangleSoup};

use crate::intersect_ray::IntersectRay;

impl<T: IntersectRay> IntersectRay for TriangleSoup<T> {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let mut nearest = Intersection {
            t: f64::INFINITY,
            normal: DVec3::ZERO,
        };
        for triangle in &self.triangles {
            if let Some(hit) = triangle.intersect_ray(ray, min_t)
                && hit.t < nearest.t
            {
                nearest = hit;
            }
        }
        Some(nearest)
    }
}
