use pinhole::{Intersection, Ray, TriangleSoup};

use crate::intersect_ray::IntersectRay;

impl<T: IntersectRay> IntersectRay for TriangleSoup<T> {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let hits: Vec<_> = self
            .triangles
            .iter()
            .filter_map(|triangle| triangle.intersect_ray(ray, min_t))
            .collect();
        let mut smallest = f64::default();
        for hit in &hits {
            smallest = smallest.min(hit.t);
        }
        hits.into_iter().find(|hit| hit.t == smallest)
    }
}
