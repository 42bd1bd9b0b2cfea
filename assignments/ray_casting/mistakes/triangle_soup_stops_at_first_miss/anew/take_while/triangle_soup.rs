use pinhole::{Intersection, Ray, TriangleSoup};

use crate::intersect_ray::IntersectRay;

impl<T: IntersectRay> IntersectRay for TriangleSoup<T> {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let mut best_t = f64::INFINITY;
        let mut best = None;
        let answers = self
            .triangles
            .iter()
            .map(|triangle| triangle.intersect_ray(ray, min_t));
        for hit in answers.take_while(Option::is_some).flatten() {
            if hit.t < best_t {
                best_t = hit.t;
                best = Some(hit);
            }
        }
        best
    }
}
