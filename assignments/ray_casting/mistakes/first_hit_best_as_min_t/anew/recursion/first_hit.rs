use pinhole::{Hit, Ray};

use crate::intersect_ray::IntersectRay;

pub fn first_hit<S: IntersectRay>(ray: &Ray, min_t: f64, objects: &[S]) -> Option<Hit> {
    let (shape, earlier) = objects.split_last()?;
    let best = first_hit(ray, min_t, earlier);
    let bound = best.map_or(min_t, |hit| hit.intersection.t);
    match shape.intersect_ray(ray, bound) {
        Some(intersection) => Some(Hit {
            object: earlier.len(),
            intersection,
        }),
        None => best,
    }
}
