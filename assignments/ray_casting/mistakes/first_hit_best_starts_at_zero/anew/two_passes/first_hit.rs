use pinhole::{Hit, Intersection, Ray};

use crate::intersect_ray::IntersectRay;

pub fn first_hit<S: IntersectRay>(ray: &Ray, min_t: f64, objects: &[S]) -> Option<Hit> {
    let found: Vec<Option<Intersection>> = objects
        .iter()
        .map(|shape| shape.intersect_ray(ray, min_t))
        .collect();
    let smallest = found
        .iter()
        .flatten()
        .fold(0.0, |smallest: f64, hit| smallest.min(hit.t));
    let object = found
        .iter()
        .position(|hit| hit.is_some_and(|hit| hit.t <= smallest))?;
    Some(Hit {
        object,
        intersection: found[object]?,
    })
}
