use pinhole::{Intersection, Ray, TriangleSoup};

use crate::intersect_ray::IntersectRay;

impl<T: IntersectRay> IntersectRay for TriangleSoup<T> {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let hits: Vec<Intersection> = self
            .triangles
            .iter()
            .filter_map(|triangle| triangle.intersect_ray(ray, min_t))
            .collect();
        let normal = hits.last()?.normal;
        let t = hits.iter().map(|hit| hit.t).fold(f64::MAX, f64::min);
        Some(Intersection { t, normal })
    }
}
