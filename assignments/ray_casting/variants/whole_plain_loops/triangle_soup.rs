use pinhole::{Intersection, Ray, TriangleSoup};

use crate::intersect_ray::IntersectRay;

impl<T: IntersectRay> IntersectRay for TriangleSoup<T> {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let mut found = false;
        let mut best_t = 0.0;
        let mut best = 0;
        for k in 0..self.triangles.len() {
            if let Some(intersection) = self.triangles[k].intersect_ray(ray, min_t) {
                if !found || intersection.t < best_t {
                    found = true;
                    best_t = intersection.t;
                    best = k;
                }
            }
        }
        if !found {
            return None;
        }
        self.triangles[best].intersect_ray(ray, min_t)
    }
}
