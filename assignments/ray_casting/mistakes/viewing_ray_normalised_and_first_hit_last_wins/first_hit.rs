use pinhole::{Hit, Ray};

use crate::intersect_ray::IntersectRay;

pub fn first_hit<S: IntersectRay>(ray: &Ray, min_t: f64, objects: &[S]) -> Option<Hit> {
    let mut last = None;
    for object in 0..objects.len() {
        match objects[object].intersect_ray(ray, min_t) {
            Some(intersection) => {
                last = Some(Hit {
                    object,
                    intersection,
                })
            }
            None => continue,
        }
    }
    last
}
