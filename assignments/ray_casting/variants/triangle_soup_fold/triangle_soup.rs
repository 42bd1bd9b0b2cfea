use pinhole::{Intersection, Ray, TriangleSoup};

use crate::intersect_ray::IntersectRay;

impl<T: IntersectRay> IntersectRay for TriangleSoup<T> {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        self.triangles
            .iter()
            .rev()
            .fold((f64::INFINITY, None), |nearest, triangle| {
                match triangle.intersect_ray(ray, min_t) {
                    Some(hit) if hit.t < nearest.0 => (hit.t, Some(hit)),
                    _ => nearest,
                }
            })
            .1
    }
}
