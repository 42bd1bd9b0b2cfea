use pinhole::{Hit, Intersection, Ray};

use crate::intersect_ray::IntersectRay;

pub fn first_hit<S: IntersectRay>(ray: &Ray, min_t: f64, objects: &[S]) -> Option<Hit> {
    let mut nearest: Option<Intersection> = None;
    let mut object = 0;
    for (index, shape) in objects.iter().enumerate() {
        if let Some(intersection) = shape.intersect_ray(ray, min_t) {
            object = index;
            if nearest.is_none_or(|best| intersection.t < best.t) {
                nearest = Some(intersection);
            }
        }
    }
    nearest.map(|intersection| Hit {
        object,
        intersection,
    })
}
