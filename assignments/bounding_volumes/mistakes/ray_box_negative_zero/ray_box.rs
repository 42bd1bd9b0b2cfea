use pinhole::{BoundingBox, Ray};

pub fn ray_box(bounds: &BoundingBox, ray: &Ray, min_t: f64, max_t: f64) -> Option<f64> {
    let (mut enter, mut leave) = (min_t, max_t);
    for axis in 0..3 {
        let d = ray.direction[axis];
        let low = bounds.min[axis] - ray.origin[axis];
        let high = bounds.max[axis] - ray.origin[axis];
        let (first, last) = if d >= 0.0 { (low, high) } else { (high, low) };
        enter = enter.max(first / d);
        leave = leave.min(last / d);
    }
    (enter <= leave).then_some(enter)
}
