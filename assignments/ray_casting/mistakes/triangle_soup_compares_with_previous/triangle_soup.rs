use pinhole::{Intersection, Ray, TriangleSoup};

use crate::intersect_ray::IntersectRay;

impl<T: IntersectRay> IntersectRay for TriangleSoup<T> {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let mut nearest = None;
        let mut previous_t = f64::INFINITY;
        for triangle in &self.triangles {
            if let Some(hit) = triangle.intersect_ray(ray, min_t) {
                if hit.t < previous_t {
                    nearest = Some(hit);
                }
                previous_t = hit.t;
            }
        }
        nearest
    }
}
