use pinhole::{Hit, Intersection, Ray};

use crate::intersect_ray::IntersectRay;

pub fn first_hit<S: IntersectRay>(ray: &Ray, min_t: f64, objects: &[S]) -> Option<Hit> {
    let mut numbers = Vec::new();
    let mut intersections: Vec<Intersection> = Vec::new();
    for (object, shape) in objects.iter().enumerate() {
        if let Some(found) = shape.intersect_ray(ray, min_t) {
            numbers.push(object);
            intersections.push(found);
        }
    }
    intersections.sort_by(|a, b| b.t.total_cmp(&a.t));
    Some(Hit {
        object: numbers.pop()?,
        intersection: intersections.pop()?,
    })
}
