use pinhole::{Hit, Ray};

use crate::intersect_ray::IntersectRay;

pub fn first_hit<S: IntersectRay>(ray: &Ray, min_t: f64, objects: &[S]) -> Option<Hit> {
    let mut nearest = None;
    let mut nearest_t = min_t;
    for (object, shape) in objects.iter().enumerate() {
        if let Some(intersection) = shape.intersect_ray(ray, nearest_t) {
            nearest_t = intersection.t;
            nearest = Some(Hit {
                object,
                intersection,
            });
        }
    }
    nearest
}
