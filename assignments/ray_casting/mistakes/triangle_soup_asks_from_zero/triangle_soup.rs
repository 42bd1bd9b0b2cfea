use pinhole::{Intersection, Ray, TriangleSoup};

use crate::intersect_ray::IntersectRay;

impl<T: IntersectRay> IntersectRay for TriangleSoup<T> {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let mut nearest: Option<Intersection> = None;
        for triangle in &self.triangles {
            let hit = triangle.intersect_ray(ray, 0.0);
            nearest = match (nearest, hit) {
                (Some(best), Some(hit)) if hit.t < best.t => Some(hit),
                (Some(best), _) => Some(best),
                (None, hit) => hit,
            };
        }
        nearest
    }
}
