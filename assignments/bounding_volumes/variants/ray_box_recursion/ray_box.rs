use pinhole::{BoundingBox, Ray};

/// Clips the interval from `enter` to `leave` by the slabs from `axis` on.
fn clip(bounds: &BoundingBox, ray: &Ray, axis: usize, enter: f64, leave: f64) -> Option<f64> {
    if enter > leave {
        return None;
    }
    if axis == 3 {
        return Some(enter);
    }
    let (e, d) = (ray.origin[axis], ray.direction[axis]);
    let (low, high) = (bounds.min[axis], bounds.max[axis]);
    if d == 0.0 {
        return if low <= e && e <= high {
            clip(bounds, ray, axis + 1, enter, leave)
        } else {
            None
        };
    }
    let (a, b) = ((low - e) / d, (high - e) / d);
    clip(
        bounds,
        ray,
        axis + 1,
        enter.max(a.min(b)),
        leave.min(a.max(b)),
    )
}

pub fn ray_box(bounds: &BoundingBox, ray: &Ray, min_t: f64, max_t: f64) -> Option<f64> {
    clip(bounds, ray, 0, min_t, max_t)
}
