use pinhole::{Hit, Ray};

use crate::intersect_ray::IntersectRay;

pub fn first_hit<S: IntersectRay>(ray: &Ray, min_t: f64, objects: &[S]) -> Option<Hit> {
    let mut hits: Vec<Hit> = Vec::new();
    for shape in objects {
        if let Some(intersection) = shape.intersect_ray(ray, min_t) {
            hits.push(Hit {
                object: hits.len(),
                intersection,
            });
        }
    }
    hits.sort_by(|a, b| a.intersection.t.total_cmp(&b.intersection.t));
    hits.into_iter().next()
}
