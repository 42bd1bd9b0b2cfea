use pinhole::{Intersection, Ray, TriangleSoup};

use crate::intersect_ray::IntersectRay;

impl<T: IntersectRay> IntersectRay for TriangleSoup<T> {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let mut front: Option<Intersection> = None;
        for triangle in &self.triangles {
            if let Some(hit) = triangle.intersect_ray(ray, min_t)
                && front.is_none_or(|best| hit.t > best.t)
            {
                front = Some(hit);
            }
        }
        front
    }
}
