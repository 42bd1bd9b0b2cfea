use pinhole::{Hit, Ray};

use crate::intersect_ray::IntersectRay;

pub fn first_hit<S: IntersectRay>(ray: &Ray, min_t: f64, objects: &[S]) -> Option<Hit> {
    let start = (0.0, None);
    let (_, nearest) = objects
        .iter()
        .enumerate()
        .fold(start, |best, (object, shape)| {
            match shape.intersect_ray(ray, min_t) {
                Some(intersection) if intersection.t < best.0 => (
                    intersection.t,
                    Some(Hit {
                        object,
                        intersection,
                    }),
                ),
                _ => best,
            }
        });
    nearest
}
