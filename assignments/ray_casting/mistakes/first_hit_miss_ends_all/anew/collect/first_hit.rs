use pinhole::{Hit, Intersection, Ray};

use crate::intersect_ray::IntersectRay;

pub fn first_hit<S: IntersectRay>(ray: &Ray, min_t: f64, objects: &[S]) -> Option<Hit> {
    let found: Option<Vec<Intersection>> = objects
        .iter()
        .map(|shape| shape.intersect_ray(ray, min_t))
        .collect();
    found?
        .into_iter()
        .enumerate()
        .map(|(object, intersection)| Hit {
            object,
            intersection,
        })
        .min_by(|a, b| a.intersection.t.total_cmp(&b.intersection.t))
}
