use pinhole::{Hit, Ray};

use crate::intersect_ray::IntersectRay;

pub fn first_hit<S: IntersectRay>(ray: &Ray, min_t: f64, objects: &[S]) -> Option<Hit> {
    let mut hit: Option<Hit> = None;
    let mut object = 0;
    while object < objects.len() {
        let so_far = match hit {
            Some(hit) => hit.intersection.t,
            None => min_t,
        };
        let answer = objects[object].intersect_ray(ray, so_far);
        hit = answer
            .map(|intersection| Hit {
                object,
                intersection,
            })
            .or(hit);
        object += 1;
    }
    hit
}
