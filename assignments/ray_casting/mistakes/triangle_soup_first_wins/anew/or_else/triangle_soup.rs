use pinhole::{Intersection, Ray, TriangleSoup};

use crate::intersect_ray::IntersectRay;

impl<T: IntersectRay> IntersectRay for TriangleSoup<T> {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let mut hit = None;
        for k in 0..self.triangles.len() {
            hit = hit.or_else(|| self.triangles[k].intersect_ray(ray, min_t));
        }
        hit
    }
}
