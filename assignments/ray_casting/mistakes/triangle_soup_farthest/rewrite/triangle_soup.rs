use pinhole::{Intersection, Ray, TriangleSoup};

use crate::intersect_ray::IntersectRay;

impl<T: IntersectRay> IntersectRay for TriangleSoup<T> {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        frontmost(&self.triangles, ray, min_t)
    }
}

fn frontmost<T: IntersectRay>(triangles: &[T], ray: &Ray, min_t: f64) -> Option<Intersection> {
    if triangles.len() <= 1 {
        return triangles.first()?.intersect_ray(ray, min_t);
    }
    let (left, right) = triangles.split_at(triangles.len() / 2);
    match (frontmost(left, ray, min_t), frontmost(right, ray, min_t)) {
        (Some(one), Some(other)) => Some(if one.t > other.t { one } else { other }),
        (one, other) => one.or(other),
    }
}
