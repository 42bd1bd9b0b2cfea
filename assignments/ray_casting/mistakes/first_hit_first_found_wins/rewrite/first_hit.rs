use pinhole::{Hit, Ray};

use crate::intersect_ray::IntersectRay;

pub fn first_hit<S: IntersectRay>(ray: &Ray, min_t: f64, objects: &[S]) -> Option<Hit> {
    let object = objects
        .iter()
        .position(|shape| shape.intersect_ray(ray, min_t).is_some())?;
    let intersection = objects[object].intersect_ray(ray, min_t)?;
    Some(Hit {
        object,
        intersection,
    })
}
