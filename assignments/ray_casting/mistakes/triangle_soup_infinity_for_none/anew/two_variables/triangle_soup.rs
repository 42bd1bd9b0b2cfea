use glam::DVec3;
use pinhole::{Intersection, Ray, TriangleSoup};

use crate::intersect_ray::IntersectRay;

impl<T: IntersectRay> IntersectRay for TriangleSoup<T> {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let (mut t, mut normal) = (f64::INFINITY, DVec3::default());
        for k in 0..self.triangles.len() {
            match self.triangles[k].intersect_ray(ray, min_t) {
                Some(hit) if hit.t < t => {
                    t = hit.t;
                    normal = hit.normal;
                }
                _ => {}
            }
        }
        Some(Intersection { t, normal })
    }
}
