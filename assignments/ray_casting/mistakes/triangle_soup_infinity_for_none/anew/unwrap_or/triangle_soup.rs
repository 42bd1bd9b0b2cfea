use glam::DVec3;
use pinhole::{Intersection, Ray, TriangleSoup};

use crate::intersect_ray::IntersectRay;

impl<T: IntersectRay> IntersectRay for TriangleSoup<T> {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let nothing = Intersection {
            t: f64::INFINITY,
            normal: DVec3::ZERO,
        };
        self.triangles
            .iter()
            .map(|triangle| triangle.intersect_ray(ray, min_t).unwrap_or(nothing))
            .min_by(|a, b| a.t.total_cmp(&b.t))
            .or(Some(nothing))
    }
}
