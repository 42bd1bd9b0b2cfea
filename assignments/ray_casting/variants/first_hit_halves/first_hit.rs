use pinhole::{Hit, Ray};

use crate::intersect_ray::IntersectRay;

pub fn first_hit<S: IntersectRay>(ray: &Ray, min_t: f64, objects: &[S]) -> Option<Hit> {
    first_of(ray, min_t, objects, 0)
}

/// `place` is where the slice begins in the whole list.
fn first_of<S: IntersectRay>(ray: &Ray, min_t: f64, objects: &[S], place: usize) -> Option<Hit> {
    match objects {
        [] => None,
        [shape] => Some(Hit {
            object: place,
            intersection: shape.intersect_ray(ray, min_t)?,
        }),
        _ => {
            let (left, right) = objects.split_at(objects.len() / 2);
            let a = first_of(ray, min_t, left, place);
            let b = first_of(ray, min_t, right, place + left.len());
            match (a, b) {
                (Some(x), Some(y)) if y.intersection.t < x.intersection.t => b,
                (None, _) => b,
                _ => a,
            }
        }
    }
}
