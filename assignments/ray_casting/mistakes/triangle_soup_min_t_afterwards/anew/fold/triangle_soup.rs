use pinhole::{Intersection, Ray, TriangleSoup};

use crate::intersect_ray::IntersectRay;

impl<T: IntersectRay> IntersectRay for TriangleSoup<T> {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let (t, nearest) = self
            .triangles
            .iter()
            .fold((f64::INFINITY, None), |best, triangle| {
                match triangle.intersect_ray(ray, 0.0) {
                    Some(hit) if hit.t < best.0 => (hit.t, Some(hit)),
                    _ => best,
                }
            });
        if t >= min_t { nearest } else { None }
    }
}
