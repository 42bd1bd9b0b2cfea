use glam::DVec3;
use pinhole::{BoundingBox, Ray};

/// How far outside a point may be.
const TOLERANCE: DVec3 = DVec3::splat(0.0001);

pub fn ray_box(bounds: &BoundingBox, ray: &Ray, min_t: f64, max_t: f64) -> Option<f64> {
    let start = ray.at(min_t);
    if start == start.clamp(bounds.min, bounds.max) {
        return Some(min_t);
    }
    let (low, high) = (bounds.min - TOLERANCE, bounds.max + TOLERANCE);
    let axes = (0..3).filter(|&axis| ray.direction[axis] != 0.0);
    let faces = axes.flat_map(|axis| [(axis, bounds.min[axis]), (axis, bounds.max[axis])]);
    faces
        .map(|(axis, face)| (face - ray.origin[axis]) / ray.direction[axis])
        .filter(|t| min_t <= *t && *t <= max_t)
        .filter(|t| {
            let point = ray.at(*t);
            point == point.clamp(low, high)
        })
        .reduce(f64::min)
}
