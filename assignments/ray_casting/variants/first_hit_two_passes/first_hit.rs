use pinhole::{Hit, Ray};

use crate::intersect_ray::IntersectRay;

pub fn first_hit<S: IntersectRay>(ray: &Ray, min_t: f64, objects: &[S]) -> Option<Hit> {
    let t = objects
        .iter()
        .filter_map(|shape| shape.intersect_ray(ray, min_t))
        .map(|intersection| intersection.t)
        .reduce(f64::min)?;
    objects.iter().enumerate().find_map(|(object, shape)| {
        let intersection = shape.intersect_ray(ray, min_t)?;
        (intersection.t == t).then_some(Hit {
            object,
            intersection,
        })
    })
}
