use pinhole::{Intersection, Ray, TriangleSoup};

use crate::intersect_ray::IntersectRay;

impl<T: IntersectRay> IntersectRay for TriangleSoup<T> {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let (first, others) = self.triangles.split_first()?;
        others
            .iter()
            .try_fold(first.intersect_ray(ray, min_t)?, |nearest, triangle| {
                let hit = triangle.intersect_ray(ray, min_t)?;
                Some(if hit.t < nearest.t { hit } else { nearest })
            })
    }
}
