use pinhole::{Intersection, Ray, TriangleSoup};

use crate::intersect_ray::IntersectRay;

impl<T: IntersectRay> IntersectRay for TriangleSoup<T> {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        for triangle in self.triangles.iter().rev() {
            if let Some(hit) = triangle.intersect_ray(ray, min_t) {
                return Some(hit);
            }
        }
        None
    }
}
