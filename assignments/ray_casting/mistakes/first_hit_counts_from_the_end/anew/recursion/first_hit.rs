use pinhole::{Hit, Ray};

use crate::intersect_ray::IntersectRay;

pub fn first_hit<S: IntersectRay>(ray: &Ray, min_t: f64, objects: &[S]) -> Option<Hit> {
    let (shape, rest) = objects.split_first()?;
    let later = first_hit(ray, min_t, rest);
    let Some(intersection) = shape.intersect_ray(ray, min_t) else {
        return later;
    };
    match later {
        Some(hit) if hit.intersection.t < intersection.t => Some(hit),
        _ => Some(Hit {
            object: rest.len(),
            intersection,
        }),
    }
}
