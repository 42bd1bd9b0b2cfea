use std::f64::consts::FRAC_PI_2;

use pinhole::{Hit, Intersection, Ray};

use crate::intersect_ray::IntersectRay;

pub fn first_hit<S: IntersectRay>(ray: &Ray, min_t: f64, objects: &[S]) -> Option<Hit> {
    objects
        .iter()
        .enumerate()
        .fold(None, |nearest: Option<Hit>, (object, shape)| {
            let Some(Intersection { t, normal }) = shape.intersect_ray(ray, min_t) else {
                return nearest;
            };
            if nearest.is_some_and(|hit| hit.intersection.t <= t) {
                return nearest;
            }
            let back = ray.direction.angle_between(normal) < FRAC_PI_2;
            let normal = if back { -normal } else { normal };
            Some(Hit {
                object,
                intersection: Intersection { t, normal },
            })
        })
}
