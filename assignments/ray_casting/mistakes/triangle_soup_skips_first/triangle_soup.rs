use pinhole::{Intersection, Ray, TriangleSoup};

use crate::intersect_ray::IntersectRay;

impl<T: IntersectRay> IntersectRay for TriangleSoup<T> {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let mut nearest: Option<Intersection> = None;
        for k in 1..self.triangles.len() {
            if let Some(hit) = self.triangles[k].intersect_ray(ray, min_t) {
                if nearest.is_none_or(|best| hit.t < best.t) {
                    nearest = Some(hit);
                }
            }
        }
        nearest
    }
}
