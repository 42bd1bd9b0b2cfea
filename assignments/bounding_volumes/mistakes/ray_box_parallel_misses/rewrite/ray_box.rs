use glam::DVec3;
use pinhole::{BoundingBox, Ray};

pub fn ray_box(bounds: &BoundingBox, ray: &Ray, min_t: f64, max_t: f64) -> Option<f64> {
    if ray.direction.cmpeq(DVec3::ZERO).any() {
        return None;
    }
    let inverse = ray.direction.recip();
    let a = (bounds.min - ray.origin) * inverse;
    let b = (bounds.max - ray.origin) * inverse;
    let enter = a.min(b).max_element().max(min_t);
    let leave = a.max(b).min_element().min(max_t);
    Some(enter).filter(|t| *t <= leave)
}
