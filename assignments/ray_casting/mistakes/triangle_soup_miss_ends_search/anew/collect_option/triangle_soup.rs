use pinhole::{Intersection, Ray, TriangleSoup};

use crate::intersect_ray::IntersectRay;

impl<T: IntersectRay> IntersectRay for TriangleSoup<T> {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let hits: Option<Vec<Intersection>> = self
            .triangles
            .iter()
            .map(|triangle| triangle.intersect_ray(ray, min_t))
            .collect();
        hits?.into_iter().min_by(|a, b| a.t.total_cmp(&b.t))
    }
}
