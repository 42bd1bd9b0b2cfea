use pinhole::{Intersection, Ray, TriangleSoup};

use crate::intersect_ray::IntersectRay;

impl<T: IntersectRay> IntersectRay for TriangleSoup<T> {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let mut met = Vec::new();
        for k in 0..self.triangles.len() {
            if let Some(hit) = self.triangles[k].intersect_ray(ray, min_t) {
                met.push(hit);
            }
        }
        met.pop()
    }
}
