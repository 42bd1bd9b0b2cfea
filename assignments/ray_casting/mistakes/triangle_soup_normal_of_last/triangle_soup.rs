use glam::DVec3;
use pinhole::{Intersection, Ray, TriangleSoup};

use crate::intersect_ray::IntersectRay;

impl<T: IntersectRay> IntersectRay for TriangleSoup<T> {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let mut hit_any = false;
        let mut nearest_t = f64::INFINITY;
        let mut normal = DVec3::ZERO;
        for triangle in &self.triangles {
            if let Some(hit) = triangle.intersect_ray(ray, min_t) {
                hit_any = true;
                nearest_t = nearest_t.min(hit.t);
                normal = hit.normal;
            }
        }
        hit_any.then_some(Intersection {
            t: nearest_t,
            normal,
        })
    }
}
