use pinhole::{Hit, Ray};

use crate::intersect_ray::IntersectRay;

pub fn first_hit<S: IntersectRay>(ray: &Ray, min_t: f64, objects: &[S]) -> Option<Hit> {
    let mut hits = Vec::new();
    for (object, shape) in objects.iter().enumerate() {
        if let Some(intersection) = shape.intersect_ray(ray, min_t) {
            hits.push(Hit {
                object,
                intersection,
            });
        }
    }
    hits.sort_by(|a, b| a.intersection.t.total_cmp(&b.intersection.t));
    hits.first().copied()
}
