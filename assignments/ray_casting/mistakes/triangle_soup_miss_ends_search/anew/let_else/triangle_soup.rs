use pinhole::{Intersection, Ray, TriangleSoup};

use crate::intersect_ray::IntersectRay;

impl<T: IntersectRay> IntersectRay for TriangleSoup<T> {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let mut best_t = f64::MAX;
        let mut best = None;
        for k in 0..self.triangles.len() {
            let Some(found) = self.triangles[k].intersect_ray(ray, min_t) else {
                return None;
            };
            if found.t < best_t {
                best_t = found.t;
                best = Some(found);
            }
        }
        best
    }
}
