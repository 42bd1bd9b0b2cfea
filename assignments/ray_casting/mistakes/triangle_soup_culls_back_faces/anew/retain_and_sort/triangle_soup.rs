use pinhole::{Intersection, Ray, TriangleSoup};

use crate::intersect_ray::IntersectRay;

impl<T: IntersectRay> IntersectRay for TriangleSoup<T> {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let mut hits: Vec<Intersection> = self
            .triangles
            .iter()
            .flat_map(|triangle| triangle.intersect_ray(ray, min_t))
            .collect();
        let towards_eye = -ray.direction;
        hits.retain(|hit| hit.normal.dot(towards_eye) > 0.0);
        hits.sort_by(|a, b| a.t.total_cmp(&b.t));
        hits.first().copied()
    }
}
