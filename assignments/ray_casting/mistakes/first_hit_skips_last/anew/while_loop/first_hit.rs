use pinhole::{Hit, Ray};

use crate::intersect_ray::IntersectRay;

pub fn first_hit<S: IntersectRay>(ray: &Ray, min_t: f64, objects: &[S]) -> Option<Hit> {
    let mut nearest = None;
    let mut nearest_t = f64::INFINITY;
    let mut object = 0;
    while object + 1 < objects.len() {
        if let Some(intersection) = objects[object].intersect_ray(ray, min_t)
            && intersection.t < nearest_t
        {
            nearest_t = intersection.t;
            nearest = Some(Hit {
                object,
                intersection,
            });
        }
        object += 1;
    }
    nearest
}
