use pinhole::{Hit, Ray};

use crate::intersect_ray::IntersectRay;

pub fn first_hit<S: IntersectRay>(ray: &Ray, min_t: f64, objects: &[S]) -> Option<Hit> {
    if objects
        .iter()
        .any(|shape| shape.intersect_ray(ray, min_t).is_none())
    {
        return None;
    }
    let t = |object: usize| {
        objects[object]
            .intersect_ray(ray, min_t)
            .map_or(f64::INFINITY, |hit| hit.t)
    };
    let object = (0..objects.len()).min_by(|a, b| t(*a).total_cmp(&t(*b)))?;
    let intersection = objects[object].intersect_ray(ray, min_t)?;
    Some(Hit {
        object,
        intersection,
    })
}
