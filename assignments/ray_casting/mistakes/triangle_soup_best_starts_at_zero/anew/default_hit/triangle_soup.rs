use glam::DVec3;
use pinhole::{Intersection, Ray, TriangleSoup};

use crate::intersect_ray::IntersectRay;

impl<T: IntersectRay> IntersectRay for TriangleSoup<T> {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let mut best = Intersection {
            t: 0.0,
            normal: DVec3::ZERO,
        };
        let mut found = false;
        for k in 0..self.triangles.len() {
            let Some(hit) = self.triangles[k].intersect_ray(ray, min_t) else {
                continue;
            };
            if hit.t < best.t {
                best = hit;
                found = true;
            }
        }
        found.then_some(best)
    }
}
