use pinhole::{Intersection, Ray, TriangleSoup};

use crate::intersect_ray::IntersectRay;

impl<T: IntersectRay> IntersectRay for TriangleSoup<T> {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let mut depth = f64::NEG_INFINITY;
        let mut seen = None;
        for k in 0..self.triangles.len() {
            let answer = self.triangles[k].intersect_ray(ray, min_t);
            let t = answer.map_or(depth, |hit| hit.t);
            if t > depth {
                depth = t;
                seen = answer;
            }
        }
        seen
    }
}
