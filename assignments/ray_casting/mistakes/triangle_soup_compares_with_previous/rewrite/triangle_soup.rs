use pinhole::{Intersection, Ray, TriangleSoup};

use crate::intersect_ray::IntersectRay;

impl<T: IntersectRay> IntersectRay for TriangleSoup<T> {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let hits = self
            .triangles
            .iter()
            .map(|triangle| triangle.intersect_ray(ray, min_t))
            .filter(Option::is_some);
        let hits: Vec<Intersection> = hits.flatten().collect();
        (1..hits.len())
            .rev()
            .find(|k| hits[*k].t < hits[*k - 1].t)
            .map(|k| hits[k])
            .or(hits.first().copied())
    }
}
