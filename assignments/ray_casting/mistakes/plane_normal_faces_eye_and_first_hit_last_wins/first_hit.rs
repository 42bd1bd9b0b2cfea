use pinhole::{Hit, Ray};

use crate::intersect_ray::IntersectRay;

pub fn first_hit<S: IntersectRay>(ray: &Ray, min_t: f64, objects: &[S]) -> Option<Hit> {
    let mut last = None;
    for object in 0..objects.len() {
        if let Some(intersection) = objects[object].intersect_ray(ray, min_t) {
            last = Some(Hit {
                object,
                intersection,
            });
        }
    }
    last
}
