use pinhole::{Hit, Ray};

use crate::intersect_ray::IntersectRay;

pub fn first_hit<S: IntersectRay>(ray: &Ray, min_t: f64, objects: &[S]) -> Option<Hit> {
    objects
        .iter()
        .enumerate()
        .fold(None, |nearest: Option<Hit>, (object, shape)| {
            let Some(found) = shape.intersect_ray(ray, min_t) else {
                return nearest;
            };
            let intersection = match nearest {
                Some(hit) if hit.intersection.t <= found.t => hit.intersection,
                _ => found,
            };
            Some(Hit {
                object,
                intersection,
            })
        })
}
