use pinhole::{Intersection, Ray, TriangleSoup};

use crate::intersect_ray::IntersectRay;

impl<T: IntersectRay> IntersectRay for TriangleSoup<T> {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let hits: Vec<_> = self
            .triangles
            .iter()
            .flat_map(|triangle| triangle.intersect_ray(ray, min_t))
            .collect();
        let mut nearest = 0;
        for k in 1..hits.len() {
            if hits[k].t < hits[k - 1].t {
                nearest = k;
            }
        }
        hits.get(nearest).copied()
    }
}
