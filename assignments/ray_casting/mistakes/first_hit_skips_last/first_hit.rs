use pinhole::{Hit, Ray};

use crate::intersect_ray::IntersectRay;

pub fn first_hit<S: IntersectRay>(ray: &Ray, min_t: f64, objects: &[S]) -> Option<Hit> {
    let mut nearest: Option<Hit> = None;
    let last = objects.len().saturating_sub(1);
    for object in 0..last {
        if let Some(intersection) = objects[object].intersect_ray(ray, min_t)
            && nearest.is_none_or(|hit| intersection.t < hit.intersection.t)
        {
            nearest = Some(Hit {
                object,
                intersection,
            });
        }
    }
    nearest
}
