use pinhole::{Hit, Ray};

use crate::intersect_ray::IntersectRay;

pub fn first_hit<S: IntersectRay>(ray: &Ray, min_t: f64, objects: &[S]) -> Option<Hit> {
    let (shape, earlier) = objects.split_last()?;
    let best = first_hit(ray, min_t, earlier);
    let here = shape.intersect_ray(ray, min_t).map(|intersection| Hit {
        object: objects.len(),
        intersection,
    });
    match (best, here) {
        (Some(a), Some(b)) if b.intersection.t < a.intersection.t => here,
        (None, _) => here,
        _ => best,
    }
}
