use pinhole::{Intersection, Ray, TriangleSoup};

use crate::intersect_ray::IntersectRay;

impl<T: IntersectRay> IntersectRay for TriangleSoup<T> {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let mut hits = Vec::new();
        for k in 0..self.triangles.len() - 1 {
            hits.extend(self.triangles[k].intersect_ray(ray, min_t));
        }
        hits.sort_by(|a: &Intersection, b| a.t.total_cmp(&b.t));
        hits.first().copied()
    }
}
