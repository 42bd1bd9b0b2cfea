use pinhole::{Hit, Ray};

use crate::intersect_ray::IntersectRay;

pub fn first_hit<S: IntersectRay>(ray: &Ray, min_t: f64, objects: &[S]) -> Option<Hit> {
    let (shape, others) = objects.split_last()?;
    let here = Hit {
        object: others.len(),
        intersection: shape.intersect_ray(ray, min_t)?,
    };
    if others.is_empty() {
        return Some(here);
    }
    let other = first_hit(ray, min_t, others)?;
    match other.intersection.t <= here.intersection.t {
        true => Some(other),
        false => Some(here),
    }
}
