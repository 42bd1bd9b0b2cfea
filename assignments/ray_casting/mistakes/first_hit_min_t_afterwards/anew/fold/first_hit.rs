use pinhole::{Hit, Ray};

use crate::intersect_ray::IntersectRay;

pub fn first_hit<S: IntersectRay>(ray: &Ray, min_t: f64, objects: &[S]) -> Option<Hit> {
    objects
        .iter()
        .enumerate()
        .fold(None, |nearest: Option<Hit>, (object, shape)| {
            let bound = nearest.map_or(f64::INFINITY, |hit| hit.intersection.t);
            match shape.intersect_ray(ray, 0.0) {
                Some(intersection) if (min_t..bound).contains(&intersection.t) => Some(Hit {
                    object,
                    intersection,
                }),
                _ => nearest,
            }
        })
}
