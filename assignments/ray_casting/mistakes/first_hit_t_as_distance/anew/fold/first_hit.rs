use pinhole::{Hit, Intersection, Ray};

use crate::intersect_ray::IntersectRay;

pub fn first_hit<S: IntersectRay>(ray: &Ray, min_t: f64, objects: &[S]) -> Option<Hit> {
    objects
        .iter()
        .enumerate()
        .fold(None, |nearest: Option<Hit>, (object, shape)| {
            let Some(found) = shape.intersect_ray(ray, min_t) else {
                return nearest;
            };
            let distance = ray.origin.distance(ray.at(found.t));
            match nearest {
                Some(hit) if hit.intersection.t <= distance => nearest,
                _ => Some(Hit {
                    object,
                    intersection: Intersection {
                        t: distance,
                        ..found
                    },
                }),
            }
        })
}
