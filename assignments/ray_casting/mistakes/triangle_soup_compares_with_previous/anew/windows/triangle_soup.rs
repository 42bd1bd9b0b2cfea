use pinhole::{Intersection, Ray, TriangleSoup};

use crate::intersect_ray::IntersectRay;

impl<T: IntersectRay> IntersectRay for TriangleSoup<T> {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let hits: Vec<Intersection> = self
            .triangles
            .iter()
            .filter_map(|triangle| triangle.intersect_ray(ray, min_t))
            .collect();
        let mut nearest = hits.first();
        for pair in hits.windows(2) {
            if pair[1].t < pair[0].t {
                nearest = Some(&pair[1]);
            }
        }
        nearest.copied()
    }
}
