use glam::DVec3;
use pinhole::{BoundingBox, Ray};

pub fn ray_box(bounds: &BoundingBox, ray: &Ray, min_t: f64, max_t: f64) -> Option<f64> {
    let (low, high) = (bounds.min - ray.origin, bounds.max - ray.origin);
    let parallel = ray.direction.cmpeq(DVec3::ZERO);
    let beside = low.cmpge(DVec3::ZERO) | high.cmple(DVec3::ZERO);
    if (parallel & beside).any() {
        return None;
    }
    let (a, b) = (low / ray.direction, high / ray.direction);
    let near = DVec3::select(parallel, DVec3::NEG_INFINITY, a.min(b)).max_element();
    let far = DVec3::select(parallel, DVec3::INFINITY, a.max(b)).min_element();
    let (enter, leave) = (near.max(min_t), far.min(max_t));
    if enter > leave { None } else { Some(enter) }
}
