use pinhole::{Intersection, Ray, TriangleSoup};

use crate::intersect_ray::IntersectRay;

impl<T: IntersectRay> IntersectRay for TriangleSoup<T> {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let mut nearest: Option<Intersection> = None;
        for quad in self.triangles.chunks_exact(2) {
            for triangle in quad {
                if let Some(hit) = triangle.intersect_ray(ray, min_t)
                    && nearest.is_none_or(|best| hit.t < best.t)
                {
                    nearest = Some(hit);
                }
            }
        }
        nearest
    }
}
