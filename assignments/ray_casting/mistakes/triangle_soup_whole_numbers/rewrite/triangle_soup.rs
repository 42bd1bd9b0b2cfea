use pinhole::{Intersection, Ray, TriangleSoup};

use crate::intersect_ray::IntersectRay;

impl<T: IntersectRay> IntersectRay for TriangleSoup<T> {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let mut nearest = None;
        let mut nearest_t = u64::MAX;
        for triangle in &self.triangles {
            if let Some(hit) = triangle.intersect_ray(ray, min_t) {
                let t = hit.t.floor() as u64;
                if t < nearest_t {
                    nearest_t = t;
                    nearest = Some(hit);
                }
            }
        }
        nearest
    }
}
