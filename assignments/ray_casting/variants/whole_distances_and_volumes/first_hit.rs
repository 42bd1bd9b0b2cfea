use pinhole::{Hit, Ray};

use crate::intersect_ray::IntersectRay;

pub fn first_hit<S: IntersectRay>(ray: &Ray, min_t: f64, objects: &[S]) -> Option<Hit> {
    let (shape, before) = objects.split_last()?;
    let earlier = first_hit(ray, min_t, before);
    let Some(intersection) = shape.intersect_ray(ray, min_t) else {
        return earlier;
    };
    let here = Hit {
        object: before.len(),
        intersection,
    };
    Some(match earlier {
        Some(hit) if hit.intersection.t <= intersection.t => hit,
        _ => here,
    })
}
