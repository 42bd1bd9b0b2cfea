use pinhole::{Hit, Ray};

use crate::intersect_ray::IntersectRay;

pub fn first_hit<S: IntersectRay>(ray: &Ray, min_t: f64, objects: &[S]) -> Option<Hit> {
    (1..)
        .zip(objects)
        .filter_map(|(object, shape)| {
            let intersection = shape.intersect_ray(ray, min_t)?;
            Some(Hit {
                object,
                intersection,
            })
        })
        .min_by(|a, b| a.intersection.t.total_cmp(&b.intersection.t))
}
