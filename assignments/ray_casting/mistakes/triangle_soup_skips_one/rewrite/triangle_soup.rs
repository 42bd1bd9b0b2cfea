use pinhole::{Intersection, Ray, TriangleSoup};

use crate::intersect_ray::IntersectRay;

impl<T: IntersectRay> IntersectRay for TriangleSoup<T> {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let count = self.triangles.len() - 1;
        self.triangles
            .iter()
            .take(count)
            .fold(None, |nearest: Option<Intersection>, triangle| {
                match (nearest, triangle.intersect_ray(ray, min_t)) {
                    (Some(best), Some(hit)) if best.t <= hit.t => Some(best),
                    (best, hit) => hit.or(best),
                }
            })
    }
}
