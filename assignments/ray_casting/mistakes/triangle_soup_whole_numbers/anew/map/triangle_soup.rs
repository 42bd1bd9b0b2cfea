use std::collections::BTreeMap;

use pinhole::{Intersection, Ray, TriangleSoup};

use crate::intersect_ray::IntersectRay;

impl<T: IntersectRay> IntersectRay for TriangleSoup<T> {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let mut by_t = BTreeMap::new();
        for triangle in &self.triangles {
            if let Some(hit) = triangle.intersect_ray(ray, min_t) {
                by_t.entry(hit.t as u32).or_insert(hit);
            }
        }
        by_t.into_values().next()
    }
}
