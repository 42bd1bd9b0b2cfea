use pinhole::{Hit, Ray};

use crate::intersect_ray::IntersectRay;

pub fn first_hit<S: IntersectRay>(ray: &Ray, min_t: f64, objects: &[S]) -> Option<Hit> {
    let start = (min_t, None);
    let search = objects
        .iter()
        .enumerate()
        .fold(start, |(bound, nearest), (object, shape)| {
            shape
                .intersect_ray(ray, bound)
                .map_or((bound, nearest), |intersection| {
                    (
                        intersection.t,
                        Some(Hit {
                            object,
                            intersection,
                        }),
                    )
                })
        });
    search.1
}
