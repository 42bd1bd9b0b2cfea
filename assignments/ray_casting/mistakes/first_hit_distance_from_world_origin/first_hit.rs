use pinhole::{Hit, Ray};

use crate::intersect_ray::IntersectRay;

pub fn first_hit<S: IntersectRay>(ray: &Ray, min_t: f64, objects: &[S]) -> Option<Hit> {
    let mut nearest = None;
    let mut nearest_distance = f64::INFINITY;
    for (object, shape) in objects.iter().enumerate() {
        if let Some(intersection) = shape.intersect_ray(ray, min_t) {
            let distance = ray.at(intersection.t).length();
            if distance < nearest_distance {
                nearest_distance = distance;
                nearest = Some(Hit {
                    object,
                    intersection,
                });
            }
        }
    }
    nearest
}
