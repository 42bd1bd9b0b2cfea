use pinhole::{Hit, Ray};

use crate::intersect_ray::IntersectRay;

pub fn first_hit<S: IntersectRay>(ray: &Ray, min_t: f64, objects: &[S]) -> Option<Hit> {
    let in_front = 0.0;
    let mut hits = vec![];
    for (object, shape) in objects.iter().enumerate() {
        let answer = shape.intersect_ray(ray, in_front);
        hits.extend(answer.map(|intersection| Hit {
            object,
            intersection,
        }));
    }
    hits.sort_by(|a, b| b.intersection.t.total_cmp(&a.intersection.t));
    hits.pop()
}
