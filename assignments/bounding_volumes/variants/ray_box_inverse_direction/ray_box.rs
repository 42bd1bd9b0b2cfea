use pinhole::{BoundingBox, Ray};

pub fn ray_box(bounds: &BoundingBox, ray: &Ray, min_t: f64, max_t: f64) -> Option<f64> {
    let (mut enter, mut leave) = (min_t, max_t);
    for axis in 0..3 {
        let inverse = ray.direction[axis].recip();
        let low = (bounds.min[axis] - ray.origin[axis]) * inverse;
        let high = (bounds.max[axis] - ray.origin[axis]) * inverse;
        let (near, far) = if inverse.is_sign_negative() {
            (high, low)
        } else {
            (low, high)
        };
        // A ray in the plane of a face has 0 · ∞ here. NaN is never the greater or the
        // smaller one, so that face does not limit the ray.
        enter = enter.max(near);
        leave = leave.min(far);
    }
    (enter <= leave).then_some(enter)
}
