use pinhole::{Hit, Ray};

use crate::intersect_ray::IntersectRay;

pub fn first_hit<S: IntersectRay>(ray: &Ray, min_t: f64, objects: &[S]) -> Option<Hit> {
    let mut hit: Option<Hit> = None;
    for object in 0..objects.len() {
        let Some(intersection) = objects[object].intersect_ray(ray, min_t) else {
            continue;
        };
        if let Some(best) = hit {
            if best.intersection.t <= intersection.t {
                continue;
            }
        }
        hit = Some(Hit {
            object,
            intersection,
        });
    }
    hit
}
