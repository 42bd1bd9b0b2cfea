use pinhole::{Hit, Ray};

use crate::intersect_ray::IntersectRay;

pub fn first_hit<S: IntersectRay>(ray: &Ray, min_t: f64, objects: &[S]) -> Option<Hit> {
    let mut shown = None;
    let mut shown_t = f64::NEG_INFINITY;
    let mut object = 0;
    while object < objects.len() {
        match objects[object].intersect_ray(ray, min_t) {
            Some(intersection) if intersection.t > shown_t => {
                shown_t = intersection.t;
                shown = Some(Hit {
                    object,
                    intersection,
                });
            }
            _ => {}
        }
        object += 1;
    }
    shown
}
