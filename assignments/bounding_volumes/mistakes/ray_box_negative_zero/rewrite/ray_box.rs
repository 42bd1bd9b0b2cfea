use glam::DVec3;
use pinhole::{BoundingBox, Ray};

pub fn ray_box(bounds: &BoundingBox, ray: &Ray, min_t: f64, max_t: f64) -> Option<f64> {
    let inverse = ray.direction.recip();
    let backwards = ray.direction.cmplt(DVec3::ZERO);
    let first = DVec3::select(backwards, bounds.max, bounds.min);
    let last = DVec3::select(backwards, bounds.min, bounds.max);
    let near = ((first - ray.origin) * inverse).to_array();
    let far = ((last - ray.origin) * inverse).to_array();
    let enter = near.into_iter().fold(min_t, f64::max);
    let leave = far.into_iter().fold(max_t, f64::min);
    if enter <= leave { Some(enter) } else { None }
}
