use pinhole::{Hit, Ray};

use crate::intersect_ray::IntersectRay;

pub fn first_hit<S: IntersectRay>(ray: &Ray, min_t: f64, objects: &[S]) -> Option<Hit> {
    objects
        .iter()
        .map_while(|shape| shape.intersect_ray(ray, min_t))
        .enumerate()
        .map(|(object, intersection)| Hit {
            object,
            intersection,
        })
        .min_by(|a, b| a.intersection.t.total_cmp(&b.intersection.t))
}
