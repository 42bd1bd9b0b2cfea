use std::f64::consts::FRAC_PI_2;

use pinhole::{Intersection, Ray, TriangleSoup};

use crate::intersect_ray::IntersectRay;

impl<T: IntersectRay> IntersectRay for TriangleSoup<T> {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let mut best_t = f64::INFINITY;
        let mut best = None;
        for k in 0..self.triangles.len() {
            if let Some(hit) = self.triangles[k].intersect_ray(ray, min_t) {
                let visible = hit.normal.angle_between(ray.direction) > FRAC_PI_2;
                if visible && hit.t < best_t {
                    best_t = hit.t;
                    best = Some(hit);
                }
            }
        }
        best
    }
}
