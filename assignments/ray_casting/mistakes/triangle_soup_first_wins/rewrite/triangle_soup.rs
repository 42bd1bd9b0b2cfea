use pinhole::{Intersection, Ray, TriangleSoup};

use crate::intersect_ray::IntersectRay;

impl<T: IntersectRay> IntersectRay for TriangleSoup<T> {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        search(&self.triangles, ray, min_t)
    }
}

fn search<T: IntersectRay>(triangles: &[T], ray: &Ray, min_t: f64) -> Option<Intersection> {
    let (triangle, rest) = triangles.split_first()?;
    match triangle.intersect_ray(ray, min_t) {
        None => search(rest, ray, min_t),
        found => found,
    }
}
