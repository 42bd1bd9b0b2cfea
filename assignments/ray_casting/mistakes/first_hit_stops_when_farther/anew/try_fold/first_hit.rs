use std::ops::ControlFlow;

use pinhole::{Hit, Ray};

use crate::intersect_ray::IntersectRay;

pub fn first_hit<S: IntersectRay>(ray: &Ray, min_t: f64, objects: &[S]) -> Option<Hit> {
    let search =
        objects
            .iter()
            .enumerate()
            .try_fold(None, |nearest: Option<Hit>, (object, shape)| {
                let Some(intersection) = shape.intersect_ray(ray, min_t) else {
                    return ControlFlow::Continue(nearest);
                };
                match nearest {
                    Some(hit) if hit.intersection.t < intersection.t => ControlFlow::Break(nearest),
                    _ => ControlFlow::Continue(Some(Hit {
                        object,
                        intersection,
                    })),
                }
            });
    match search {
        ControlFlow::Break(nearest) | ControlFlow::Continue(nearest) => nearest,
    }
}
