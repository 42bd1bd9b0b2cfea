use pinhole::{Hit, Ray};

use crate::intersect_ray::IntersectRay;

pub fn first_hit<S: IntersectRay>(ray: &Ray, min_t: f64, objects: &[S]) -> Option<Hit> {
    objects
        .iter()
        .enumerate()
        .fold(None, |earlier, (object, shape)| {
            let now = shape.intersect_ray(ray, min_t);
            now.map(|intersection| Hit {
                object,
                intersection,
            })
            .or(earlier)
        })
}
