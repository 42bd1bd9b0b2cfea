use pinhole::{Hit, Ray};

use crate::intersect_ray::IntersectRay;

pub fn first_hit<S: IntersectRay>(ray: &Ray, min_t: f64, objects: &[S]) -> Option<Hit> {
    search(ray, min_t, objects, 0, 0.0)
}

fn search<S: IntersectRay>(
    ray: &Ray,
    min_t: f64,
    objects: &[S],
    object: usize,
    best_t: f64,
) -> Option<Hit> {
    let shape = objects.get(object)?;
    match shape.intersect_ray(ray, min_t) {
        Some(intersection) if intersection.t < best_t => {
            let here = Hit {
                object,
                intersection,
            };
            search(ray, min_t, objects, object + 1, intersection.t).or(Some(here))
        }
        _ => search(ray, min_t, objects, object + 1, best_t),
    }
}
