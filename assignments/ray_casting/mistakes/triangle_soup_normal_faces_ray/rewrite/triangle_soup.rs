use pinhole::{Intersection, Ray, TriangleSoup};

use crate::intersect_ray::IntersectRay;

impl<T: IntersectRay> IntersectRay for TriangleSoup<T> {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let mut nearest: Option<Intersection> = None;
        for triangle in &self.triangles {
            if let Some(mut hit) = triangle.intersect_ray(ray, min_t) {
                if ray.direction.dot(hit.normal) > 0.0 {
                    hit.normal = -hit.normal;
                }
                if nearest.is_none_or(|best| hit.t < best.t) {
                    nearest = Some(hit);
                }
            }
        }
        nearest
    }
}
