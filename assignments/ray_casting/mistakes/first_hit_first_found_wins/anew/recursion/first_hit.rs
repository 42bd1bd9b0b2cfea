use pinhole::{Hit, Ray};

use crate::intersect_ray::IntersectRay;

pub fn first_hit<S: IntersectRay>(ray: &Ray, min_t: f64, objects: &[S]) -> Option<Hit> {
    let (shape, earlier) = objects.split_last()?;
    first_hit(ray, min_t, earlier).or_else(|| {
        let intersection = shape.intersect_ray(ray, min_t)?;
        Some(Hit {
            object: earlier.len(),
            intersection,
        })
    })
}
