use pinhole::{Intersection, Ray, TriangleSoup};

use crate::intersect_ray::IntersectRay;

impl<T: IntersectRay> IntersectRay for TriangleSoup<T> {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let (_, nearest) = self
            .triangles
            .iter()
            .filter_map(|triangle| triangle.intersect_ray(ray, min_t))
            .fold((0.0, None), |(smallest, nearest), hit| {
                if hit.t < smallest {
                    (hit.t, Some(hit))
                } else {
                    (smallest, nearest)
                }
            });
        nearest
    }
}
