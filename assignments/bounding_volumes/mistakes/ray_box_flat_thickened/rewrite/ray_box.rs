use glam::DVec3;
use pinhole::{BoundingBox, Ray};

/// Half of the thickness of a flat box.
const HALF: DVec3 = DVec3::splat(0.0001);

pub fn ray_box(bounds: &BoundingBox, ray: &Ray, min_t: f64, max_t: f64) -> Option<f64> {
    let is_flat = bounds.min.cmpeq(bounds.max);
    let padding = DVec3::select(is_flat, HALF, DVec3::ZERO);
    let low = bounds.min - padding - ray.origin;
    let high = bounds.max + padding - ray.origin;
    let parallel = ray.direction.cmpeq(DVec3::ZERO);
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
