use pinhole::{Hit, Ray};

use crate::intersect_ray::IntersectRay;

pub fn first_hit<S: IntersectRay>(ray: &Ray, min_t: f64, objects: &[S]) -> Option<Hit> {
    let last = objects.len().checked_sub(1)?;
    between(ray, min_t, objects, 0, last)
}

fn between<S: IntersectRay>(
    ray: &Ray,
    min_t: f64,
    objects: &[S],
    from: usize,
    to: usize,
) -> Option<Hit> {
    if to - from <= 1 {
        let shape = objects[from..to].first()?;
        let intersection = shape.intersect_ray(ray, min_t)?;
        return Some(Hit {
            object: from,
            intersection,
        });
    }
    let middle = (from + to) / 2;
    let left = between(ray, min_t, objects, from, middle);
    let right = between(ray, min_t, objects, middle, to);
    match (left, right) {
        (Some(a), Some(b)) if b.intersection.t < a.intersection.t => right,
        (None, _) => right,
        _ => left,
    }
}
