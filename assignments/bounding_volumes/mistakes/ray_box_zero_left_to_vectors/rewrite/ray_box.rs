use pinhole::{BoundingBox, Ray};

pub fn ray_box(bounds: &BoundingBox, ray: &Ray, min_t: f64, max_t: f64) -> Option<f64> {
    let inverse = ray.direction.recip();
    let [low, high] = [bounds.min, bounds.max].map(|corner| (corner - ray.origin) * inverse);
    let (near, far) = (low.min(high), low.max(high));
    let first = min_t.max(near.max_element());
    let last = max_t.min(far.min_element());
    if last < first {
        return None;
    }
    Some(first)
}
