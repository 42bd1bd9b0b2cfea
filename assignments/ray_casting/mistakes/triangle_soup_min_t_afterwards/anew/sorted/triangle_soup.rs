use pinhole::{Intersection, Ray, TriangleSoup};

use crate::intersect_ray::IntersectRay;

impl<T: IntersectRay> IntersectRay for TriangleSoup<T> {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let mut hits = Vec::with_capacity(self.triangles.len());
        for k in 0..self.triangles.len() {
            hits.extend(self.triangles[k].intersect_ray(ray, 0.0));
        }
        hits.sort_by(|a: &Intersection, b| a.t.total_cmp(&b.t));
        match hits.first() {
            Some(hit) if hit.t >= min_t => Some(*hit),
            _ => None,
        }
    }
}
