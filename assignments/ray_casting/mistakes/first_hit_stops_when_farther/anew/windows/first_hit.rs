use pinhole::{Hit, Ray};

use crate::intersect_ray::IntersectRay;

pub fn first_hit<S: IntersectRay>(ray: &Ray, min_t: f64, objects: &[S]) -> Option<Hit> {
    let hits: Vec<Hit> = objects
        .iter()
        .enumerate()
        .filter_map(|(object, shape)| {
            let intersection = shape.intersect_ray(ray, min_t)?;
            Some(Hit {
                object,
                intersection,
            })
        })
        .collect();
    let turn = hits
        .windows(2)
        .find(|pair| pair[1].intersection.t > pair[0].intersection.t);
    turn.map(|pair| pair[0]).or(hits.last().copied())
}
