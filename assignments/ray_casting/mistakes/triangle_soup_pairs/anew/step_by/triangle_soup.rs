use pinhole::{Intersection, Ray, TriangleSoup};

use crate::intersect_ray::IntersectRay;

impl<T: IntersectRay> IntersectRay for TriangleSoup<T> {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let ask = |k: usize| self.triangles[k].intersect_ray(ray, min_t);
        (1..self.triangles.len())
            .step_by(2)
            .flat_map(|second| [ask(second - 1), ask(second)])
            .flatten()
            .min_by(|a, b| a.t.total_cmp(&b.t))
    }
}
