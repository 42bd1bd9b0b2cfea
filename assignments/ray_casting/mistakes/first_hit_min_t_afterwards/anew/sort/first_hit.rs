use pinhole::{Hit, Ray};

use crate::intersect_ray::IntersectRay;

pub fn first_hit<S: IntersectRay>(ray: &Ray, min_t: f64, objects: &[S]) -> Option<Hit> {
    let mut hits: Vec<Hit> = Vec::new();
    for object in 0..objects.len() {
        if let Some(intersection) = objects[object].intersect_ray(ray, 0.0) {
            hits.push(Hit {
                object,
                intersection,
            });
        }
    }
    hits.sort_by(|a, b| a.intersection.t.total_cmp(&b.intersection.t));
    let before = hits.partition_point(|hit| hit.intersection.t < min_t);
    hits.get(before).copied()
}
