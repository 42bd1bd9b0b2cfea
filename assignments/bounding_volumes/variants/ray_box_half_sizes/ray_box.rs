use pinhole::{BoundingBox, Ray};

pub fn ray_box(bounds: &BoundingBox, ray: &Ray, min_t: f64, max_t: f64) -> Option<f64> {
    let half = 0.5 * (bounds.max - bounds.min);
    let middle = bounds.center() - ray.origin;
    let (mut enter, mut leave) = (min_t, max_t);
    for axis in 0..3 {
        let along = ray.direction[axis];
        if along == 0.0 {
            let at = ray.origin[axis];
            if at < bounds.min[axis] || at > bounds.max[axis] {
                return None;
            }
            continue;
        }
        let (t, reach) = (middle[axis] / along, half[axis] / along.abs());
        enter = enter.max(t - reach);
        leave = leave.min(t + reach);
    }
    (enter <= leave).then_some(enter)
}
