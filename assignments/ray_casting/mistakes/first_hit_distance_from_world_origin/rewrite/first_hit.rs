use glam::DVec3;
use pinhole::{Hit, Ray};

use crate::intersect_ray::IntersectRay;

pub fn first_hit<S: IntersectRay>(ray: &Ray, min_t: f64, objects: &[S]) -> Option<Hit> {
    nearest(ray, min_t, objects, 0).map(|(_, hit)| hit)
}

fn nearest<S: IntersectRay>(
    ray: &Ray,
    min_t: f64,
    objects: &[S],
    object: usize,
) -> Option<(f64, Hit)> {
    match objects {
        [] => None,
        [shape] => {
            let intersection = shape.intersect_ray(ray, min_t)?;
            let from_zero = ray.at(intersection.t).distance(DVec3::ZERO);
            Some((
                from_zero,
                Hit {
                    object,
                    intersection,
                },
            ))
        }
        _ => {
            let (left, right) = objects.split_at(objects.len() / 2);
            let a = nearest(ray, min_t, left, object);
            let b = nearest(ray, min_t, right, object + left.len());
            match (a, b) {
                (Some(a), Some(b)) => Some(if b.0 < a.0 { b } else { a }),
                (a, b) => a.or(b),
            }
        }
    }
}
