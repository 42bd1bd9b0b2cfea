use pinhole::{Hit, Ray};

use crate::intersect_ray::IntersectRay;

pub fn first_hit<S: IntersectRay>(ray: &Ray, min_t: f64, objects: &[S]) -> Option<Hit> {
    (0..objects.len()).rev().find_map(|object| {
        objects[object]
            .intersect_ray(ray, min_t)
            .map(|intersection| Hit {
                object,
                intersection,
            })
    })
}
