use pinhole::{Hit, Ray};

use crate::intersect_ray::IntersectRay;

pub fn first_hit<S: IntersectRay>(ray: &Ray, min_t: f64, objects: &[S]) -> Option<Hit> {
    objects.iter().enumerate().find_map(|(object, shape)| {
        shape.intersect_ray(ray, min_t).map(|intersection| Hit {
            object,
            intersection,
        })
    })
}
