use pinhole::{Intersection, Ray, TriangleSoup};

use crate::intersect_ray::IntersectRay;

impl<T: IntersectRay> IntersectRay for TriangleSoup<T> {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        self.triangles.iter().fold(None, |before, triangle| {
            triangle.intersect_ray(ray, min_t).or(before)
        })
    }
}
