use pinhole::{Hit, Ray};

use crate::intersect_ray::IntersectRay;

pub fn first_hit<S: IntersectRay>(ray: &Ray, min_t: f64, objects: &[S]) -> Option<Hit> {
    let mut nearest: Option<Hit> = None;
    let mut object = 0;
    for shape in objects {
        let Some(intersection) = shape.intersect_ray(ray, min_t) else {
            continue;
        };
        if nearest.is_none_or(|hit| intersection.t < hit.intersection.t) {
            nearest = Some(Hit {
                object,
                intersection,
            });
        }
        object += 1;
    }
    nearest
}
