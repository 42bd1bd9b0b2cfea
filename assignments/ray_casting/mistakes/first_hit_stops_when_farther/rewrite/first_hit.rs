use pinhole::{Hit, Ray};

use crate::intersect_ray::IntersectRay;

pub fn first_hit<S: IntersectRay>(ray: &Ray, min_t: f64, objects: &[S]) -> Option<Hit> {
    descend(ray, min_t, objects, 0, f64::INFINITY)
}

fn descend<S: IntersectRay>(
    ray: &Ray,
    min_t: f64,
    objects: &[S],
    object: usize,
    bound: f64,
) -> Option<Hit> {
    let shape = objects.get(object)?;
    match shape.intersect_ray(ray, min_t) {
        None => descend(ray, min_t, objects, object + 1, bound),
        Some(intersection) if intersection.t > bound => None,
        Some(intersection) => {
            descend(ray, min_t, objects, object + 1, intersection.t).or(Some(Hit {
                object,
                intersection,
            }))
        }
    }
}
