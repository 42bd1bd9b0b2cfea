use pinhole::{Hit, Ray};

use crate::intersect_ray::IntersectRay;

pub fn first_hit<S: IntersectRay>(ray: &Ray, min_t: f64, objects: &[S]) -> Option<Hit> {
    let mut shapes = objects.iter().enumerate();
    let mut nearest_t = f64::INFINITY;
    let mut nearest = None;
    while let Some((object, shape)) = shapes.next()
        && let Some(intersection) = shape.intersect_ray(ray, min_t)
    {
        if intersection.t < nearest_t {
            nearest_t = intersection.t;
            nearest = Some(Hit {
                object,
                intersection,
            });
        }
    }
    nearest
}
