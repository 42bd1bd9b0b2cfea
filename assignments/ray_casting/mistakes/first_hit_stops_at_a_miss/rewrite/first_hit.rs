use pinhole::{Hit, Ray};

use crate::intersect_ray::IntersectRay;

pub fn first_hit<S: IntersectRay>(ray: &Ray, min_t: f64, objects: &[S]) -> Option<Hit> {
    from(ray, min_t, objects, 0)
}

fn from<S: IntersectRay>(ray: &Ray, min_t: f64, objects: &[S], object: usize) -> Option<Hit> {
    let intersection = objects.get(object)?.intersect_ray(ray, min_t)?;
    let here = Hit {
        object,
        intersection,
    };
    let later = from(ray, min_t, objects, object + 1);
    Some(
        later
            .filter(|hit| hit.intersection.t < intersection.t)
            .unwrap_or(here),
    )
}
