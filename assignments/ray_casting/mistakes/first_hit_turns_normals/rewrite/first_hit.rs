use pinhole::{Hit, Ray};

use crate::intersect_ray::IntersectRay;

pub fn first_hit<S: IntersectRay>(ray: &Ray, min_t: f64, objects: &[S]) -> Option<Hit> {
    let mut hit = objects
        .iter()
        .enumerate()
        .filter_map(|(object, shape)| {
            let intersection = shape.intersect_ray(ray, min_t)?;
            Some(Hit {
                object,
                intersection,
            })
        })
        .min_by(|a, b| a.intersection.t.total_cmp(&b.intersection.t))?;
    let facing = -hit.intersection.normal.dot(ray.direction).signum();
    hit.intersection.normal *= facing;
    Some(hit)
}
