use pinhole::{Intersection, Ray, TriangleSoup};

use crate::intersect_ray::IntersectRay;

impl<T: IntersectRay> IntersectRay for TriangleSoup<T> {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let mut hit = None;
        for triangle in &self.triangles {
            let met = triangle.intersect_ray(ray, min_t);
            if met.is_some() {
                hit = met;
            }
        }
        hit
    }
}
