use pinhole::{Intersection, Ray, TriangleSoup};

use crate::intersect_ray::IntersectRay;

impl<T: IntersectRay> IntersectRay for TriangleSoup<T> {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let mut hits = Vec::new();
        for triangle in &self.triangles {
            if let Some(hit) = triangle.intersect_ray(ray, min_t) {
                hits.push(hit);
            }
            if hits.len() == 2 {
                break;
            }
        }
        hits.into_iter()
            .min_by(|a: &Intersection, b| a.t.total_cmp(&b.t))
    }
}
