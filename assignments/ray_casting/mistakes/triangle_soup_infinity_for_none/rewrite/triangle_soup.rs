use glam::DVec3;
use pinhole::{Intersection, Ray, TriangleSoup};

use crate::intersect_ray::IntersectRay;

impl<T: IntersectRay> IntersectRay for TriangleSoup<T> {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let far_away = Intersection {
            t: f64::INFINITY,
            normal: DVec3::ZERO,
        };
        let nearer = |nearest: Intersection, hit: Intersection| {
            if hit.t < nearest.t { hit } else { nearest }
        };
        Some(
            self.triangles
                .iter()
                .filter_map(|triangle| triangle.intersect_ray(ray, min_t))
                .fold(far_away, nearer),
        )
    }
}
