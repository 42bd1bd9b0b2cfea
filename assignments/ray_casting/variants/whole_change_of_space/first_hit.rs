use pinhole::{Hit, Ray};

use crate::intersect_ray::IntersectRay;

pub fn first_hit<S: IntersectRay>(ray: &Ray, min_t: f64, objects: &[S]) -> Option<Hit> {
    let asked = |object: usize| {
        let intersection = objects[object].intersect_ray(ray, min_t)?;
        Some(Hit {
            object,
            intersection,
        })
    };
    (0..objects.len()).filter_map(asked).reduce(|best, hit| {
        if hit.intersection.t < best.intersection.t {
            hit
        } else {
            best
        }
    })
}
