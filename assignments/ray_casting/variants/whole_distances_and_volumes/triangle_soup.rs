use pinhole::{Intersection, Ray, TriangleSoup};

use crate::intersect_ray::IntersectRay;

impl<T: IntersectRay> IntersectRay for TriangleSoup<T> {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        nearest(ray, min_t, &self.triangles)
    }
}

fn nearest<T: IntersectRay>(ray: &Ray, min_t: f64, triangles: &[T]) -> Option<Intersection> {
    match triangles {
        [] => None,
        [triangle] => triangle.intersect_ray(ray, min_t),
        _ => {
            let (left, right) = triangles.split_at(triangles.len() / 2);
            let left = nearest(ray, min_t, left);
            let right = nearest(ray, min_t, right);
            match (left, right) {
                (Some(a), Some(b)) => Some(if a.t <= b.t { a } else { b }),
                (a, b) => a.or(b),
            }
        }
    }
}
