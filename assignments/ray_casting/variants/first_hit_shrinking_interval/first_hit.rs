use pinhole::{Hit, Ray};

use crate::intersect_ray::IntersectRay;

pub fn first_hit<S: IntersectRay>(ray: &Ray, min_t: f64, objects: &[S]) -> Option<Hit> {
    let mut bound = f64::INFINITY;
    let mut nearest = None;
    let mut object = 0;
    while object < objects.len() {
        match objects[object].intersect_ray(ray, min_t) {
            Some(intersection) if intersection.t < bound => {
                bound = intersection.t;
                nearest = Some(Hit {
                    object,
                    intersection,
                });
            }
            _ => {}
        }
        object += 1;
    }
    nearest
}
