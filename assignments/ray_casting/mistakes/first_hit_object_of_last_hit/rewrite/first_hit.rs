use pinhole::{Hit, Ray};

use crate::intersect_ray::IntersectRay;

pub fn first_hit<S: IntersectRay>(ray: &Ray, min_t: f64, objects: &[S]) -> Option<Hit> {
    let found = || {
        objects
            .iter()
            .enumerate()
            .filter_map(|(object, shape)| Some((object, shape.intersect_ray(ray, min_t)?)))
    };
    let (object, _) = found().last()?;
    let (_, intersection) = found().min_by(|(_, a), (_, b)| a.t.total_cmp(&b.t))?;
    Some(Hit {
        object,
        intersection,
    })
}
