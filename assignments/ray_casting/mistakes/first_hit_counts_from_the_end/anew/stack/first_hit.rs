use pinhole::{Hit, Ray};

use crate::intersect_ray::IntersectRay;

pub fn first_hit<S: IntersectRay>(ray: &Ray, min_t: f64, objects: &[S]) -> Option<Hit> {
    let mut waiting: Vec<&S> = objects.iter().collect();
    let mut asked = 0;
    let mut nearest_t = f64::INFINITY;
    let mut nearest = None;
    while let Some(shape) = waiting.pop() {
        if let Some(intersection) = shape.intersect_ray(ray, min_t)
            && intersection.t < nearest_t
        {
            nearest_t = intersection.t;
            nearest = Some(Hit {
                object: asked,
                intersection,
            });
        }
        asked += 1;
    }
    nearest
}
