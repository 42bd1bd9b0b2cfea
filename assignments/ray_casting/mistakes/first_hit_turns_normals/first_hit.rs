use pinhole::{Hit, Ray};

use crate::intersect_ray::IntersectRay;

pub fn first_hit<S: IntersectRay>(ray: &Ray, min_t: f64, objects: &[S]) -> Option<Hit> {
    let mut nearest: Option<Hit> = None;
    for (object, shape) in objects.iter().enumerate() {
        let Some(mut intersection) = shape.intersect_ray(ray, min_t) else {
            continue;
        };
        if intersection.normal.dot(ray.direction) > 0.0 {
            intersection.normal = -intersection.normal;
        }
        if nearest.is_none_or(|hit| intersection.t < hit.intersection.t) {
            nearest = Some(Hit {
                object,
                intersection,
            });
        }
    }
    nearest
}
