use pinhole::{Intersection, Ray, TriangleSoup};

use crate::intersect_ray::IntersectRay;

impl<T: IntersectRay> IntersectRay for TriangleSoup<T> {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        nearest(&self.triangles, ray, min_t)
    }
}

fn nearest<T: IntersectRay>(triangles: &[T], ray: &Ray, min_t: f64) -> Option<Intersection> {
    match triangles {
        [] => None,
        [triangle] => triangle.intersect_ray(ray, min_t),
        _ => {
            let (left, right) = triangles.split_at(triangles.len() / 2);
            let (left, right) = (nearest(left, ray, min_t), nearest(right, ray, min_t));
            match (left, right) {
                (Some(l), Some(r)) => Some(if r.t < l.t { r } else { l }),
                _ => left.or(right),
            }
        }
    }
}
