use pinhole::{Intersection, Ray, TriangleSoup};

use crate::intersect_ray::IntersectRay;

impl<T: IntersectRay> IntersectRay for TriangleSoup<T> {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let mut found: Vec<Intersection> = self
            .triangles
            .iter()
            .flat_map(|triangle| triangle.intersect_ray(ray, min_t))
            .collect();
        found.sort_unstable_by(|a, b| b.t.total_cmp(&a.t));
        found.pop()
    }
}
