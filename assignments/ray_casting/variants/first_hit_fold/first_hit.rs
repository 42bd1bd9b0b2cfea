use pinhole::{Hit, Ray};

use crate::intersect_ray::IntersectRay;

pub fn first_hit<S: IntersectRay>(ray: &Ray, min_t: f64, objects: &[S]) -> Option<Hit> {
    objects
        .iter()
        .enumerate()
        .fold(None, |nearest: Option<Hit>, (object, shape)| {
            let found = shape.intersect_ray(ray, min_t).map(|intersection| Hit {
                object,
                intersection,
            });
            match (nearest, found) {
                (Some(a), Some(b)) if b.intersection.t < a.intersection.t => found,
                (None, _) => found,
                _ => nearest,
            }
        })
}
