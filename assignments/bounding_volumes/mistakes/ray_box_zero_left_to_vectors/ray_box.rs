use pinhole::{BoundingBox, Ray};

pub fn ray_box(bounds: &BoundingBox, ray: &Ray, min_t: f64, max_t: f64) -> Option<f64> {
    let a = (bounds.min - ray.origin) / ray.direction;
    let b = (bounds.max - ray.origin) / ray.direction;
    let enter = a.min(b).max_element().max(min_t);
    let leave = a.max(b).min_element().min(max_t);
    (enter <= leave).then_some(enter)
}
