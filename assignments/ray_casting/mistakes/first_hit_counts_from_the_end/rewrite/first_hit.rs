use pinhole::{Hit, Ray};

use crate::intersect_ray::IntersectRay;

pub fn first_hit<S: IntersectRay>(ray: &Ray, min_t: f64, objects: &[S]) -> Option<Hit> {
    objects
        .iter()
        .rev()
        .map(|shape| shape.intersect_ray(ray, min_t))
        .enumerate()
        .filter_map(|(object, answer)| {
            Some(Hit {
                object,
                intersection: answer?,
            })
        })
        .min_by(|a, b| a.intersection.t.total_cmp(&b.intersection.t))
}
