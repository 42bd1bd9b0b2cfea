use glam::DVec3;
use pinhole::{Hit, Intersection, Ray};

use crate::intersect_ray::IntersectRay;

pub fn first_hit<S: IntersectRay>(ray: &Ray, min_t: f64, objects: &[S]) -> Option<Hit> {
    let mut seen: Vec<(f64, usize, DVec3)> = Vec::new();
    for (object, shape) in objects.iter().enumerate() {
        if let Some(found) = shape.intersect_ray(ray, min_t) {
            let to_eye = ray.origin - ray.at(found.t);
            let front = if found.normal.dot(to_eye) < 0.0 {
                -found.normal
            } else {
                found.normal
            };
            seen.push((found.t, object, front));
        }
    }
    seen.sort_by(|a, b| a.0.total_cmp(&b.0));
    let &(t, object, normal) = seen.first()?;
    Some(Hit {
        object,
        intersection: Intersection { t, normal },
    })
}
