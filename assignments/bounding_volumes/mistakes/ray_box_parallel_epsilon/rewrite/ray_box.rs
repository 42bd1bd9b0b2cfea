use glam::DVec3;
use pinhole::{BoundingBox, Ray};

/// A component of the direction that is smaller counts as 0.
const EPSILON: f64 = 0.001;

pub fn ray_box(bounds: &BoundingBox, ray: &Ray, min_t: f64, max_t: f64) -> Option<f64> {
    let (low, high) = (bounds.min - ray.origin, bounds.max - ray.origin);
    let parallel = ray.direction.abs().cmplt(DVec3::splat(EPSILON));
    let beside = low.cmpgt(DVec3::ZERO) | high.cmplt(DVec3::ZERO);
    if (parallel & beside).any() {
        return None;
    }
    let (a, b) = (low / ray.direction, high / ray.direction);
    let near = DVec3::select(parallel, DVec3::NEG_INFINITY, a.min(b)).max_element();
    let far = DVec3::select(parallel, DVec3::INFINITY, a.max(b)).min_element();
    let (enter, leave) = (near.max(min_t), far.min(max_t));
    if enter > leave { None } else { Some(enter) }
}
