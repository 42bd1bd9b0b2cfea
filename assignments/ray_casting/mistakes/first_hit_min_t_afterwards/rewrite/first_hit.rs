use pinhole::{Hit, Ray};

use crate::intersect_ray::IntersectRay;

pub fn first_hit<S: IntersectRay>(ray: &Ray, min_t: f64, objects: &[S]) -> Option<Hit> {
    objects
        .iter()
        .enumerate()
        .filter_map(|(object, shape)| {
            let intersection = shape.intersect_ray(ray, 0.0)?;
            Some(Hit {
                object,
                intersection,
            })
        })
        .filter(|hit| hit.intersection.t >= min_t)
        .min_by(|a, b| a.intersection.t.total_cmp(&b.intersection.t))
}
