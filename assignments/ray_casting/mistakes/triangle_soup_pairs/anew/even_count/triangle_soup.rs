use pinhole::{Intersection, Ray, TriangleSoup};

use crate::intersect_ray::IntersectRay;

impl<T: IntersectRay> IntersectRay for TriangleSoup<T> {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let quads = self.triangles.len() / 2;
        let mut best_t = f64::INFINITY;
        let mut best = None;
        for quad in 0..quads {
            for k in [2 * quad, 2 * quad + 1] {
                let hit = self.triangles[k].intersect_ray(ray, min_t);
                if let Some(Intersection { t, .. }) = hit
                    && t < best_t
                {
                    best_t = t;
                    best = hit;
                }
            }
        }
        best
    }
}
