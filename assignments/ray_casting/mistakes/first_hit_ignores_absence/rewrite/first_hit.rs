use pinhole::{Hit, Ray};

use crate::intersect_ray::IntersectRay;

pub fn first_hit<S: IntersectRay>(ray: &Ray, min_t: f64, objects: &[S]) -> Option<Hit> {
    let mut hits = Vec::with_capacity(objects.len());
    for object in 0..objects.len() {
        let answer = objects[object].intersect_ray(ray, min_t);
        hits.push(Hit {
            object,
            intersection: answer.expect("an intersection"),
        });
    }
    hits.sort_by(|a, b| a.intersection.t.total_cmp(&b.intersection.t));
    hits.first().copied()
}
