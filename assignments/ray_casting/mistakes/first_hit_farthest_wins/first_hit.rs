use pinhole::{Hit, Ray};

use crate::intersect_ray::IntersectRay;

pub fn first_hit<S: IntersectRay>(ray: &Ray, min_t: f64, objects: &[S]) -> Option<Hit> {
    let mut top: Option<Hit> = None;
    for (object, shape) in objects.iter().enumerate() {
        if let Some(intersection) = shape.intersect_ray(ray, min_t)
            && top.is_none_or(|hit| intersection.t > hit.intersection.t)
        {
            top = Some(Hit {
                object,
                intersection,
            });
        }
    }
    top
}
