use pinhole::{Hit, Ray};

use crate::intersect_ray::IntersectRay;

/// Where the ray leaves the eye.
const EYE: f64 = 0.0;

pub fn first_hit<S: IntersectRay>(ray: &Ray, min_t: f64, objects: &[S]) -> Option<Hit> {
    fn nearest<S: IntersectRay>(ray: &Ray, objects: &[S], first: usize) -> Option<Hit> {
        if let [shape] = objects {
            let intersection = shape.intersect_ray(ray, EYE)?;
            return Some(Hit {
                object: first,
                intersection,
            });
        }
        if objects.is_empty() {
            return None;
        }
        let middle = objects.len() / 2;
        let (left, right) = objects.split_at(middle);
        let left = nearest(ray, left, first);
        let right = nearest(ray, right, first + middle);
        [left, right].into_iter().flatten().reduce(|a, b| {
            if b.intersection.t < a.intersection.t {
                b
            } else {
                a
            }
        })
    }
    nearest(ray, objects, 0)
}
