use pinhole::{Hit, Ray};

use crate::intersect_ray::IntersectRay;

pub fn first_hit<S: IntersectRay>(ray: &Ray, min_t: f64, objects: &[S]) -> Option<Hit> {
    let mut painted = Vec::new();
    for (object, shape) in objects.iter().enumerate() {
        if let Some(intersection) = shape.intersect_ray(ray, min_t) {
            painted.push(Hit {
                object,
                intersection,
            });
        }
    }
    painted.sort_by(|below, above| below.intersection.t.total_cmp(&above.intersection.t));
    painted.pop()
}
