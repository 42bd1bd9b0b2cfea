use pinhole::{Hit, Ray};

use crate::intersect_ray::IntersectRay;

pub fn first_hit<S: IntersectRay>(ray: &Ray, min_t: f64, objects: &[S]) -> Option<Hit> {
    let mut first: Option<Hit> = None;
    for number in 1..=objects.len() {
        let Some(intersection) = objects[number - 1].intersect_ray(ray, min_t) else {
            continue;
        };
        first = match first {
            Some(hit) if hit.intersection.t <= intersection.t => Some(hit),
            _ => Some(Hit {
                object: number,
                intersection,
            }),
        };
    }
    first
}
