use pinhole::{Hit, Ray};

use crate::intersect_ray::IntersectRay;

pub fn first_hit<S: IntersectRay>(ray: &Ray, min_t: f64, objects: &[S]) -> Option<Hit> {
    let mut nearest: Option<Hit> = None;
    for (object, shape) in objects.iter().enumerate() {
        let Some(intersection) = shape.intersect_ray(ray, min_t) else {
            continue;
        };
        if nearest.is_some_and(|hit| intersection.t > hit.intersection.t) {
            break;
        }
        nearest = Some(Hit {
            object,
            intersection,
        });
    }
    nearest
}
