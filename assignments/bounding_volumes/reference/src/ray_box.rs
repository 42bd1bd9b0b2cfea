use pinhole::{BoundingBox, Ray};

// ANCHOR: stub
/// The t at which a ray enters a box: the smallest t with `min_t` ≤ t ≤ `max_t` at which
/// `ray.at(t)` lies in the box.
///
/// The box is solid and includes its faces. A ray that is in the box at `min_t` enters at
/// `min_t`. `max_t` may be infinite. `None` if the ray is outside the box at every t from
/// `min_t` to `max_t`.
///
/// A component of `ray.direction` may be 0, and the box may be flat. t is in multiples of
/// `ray.direction`, which is not a unit vector.
///
/// Book: Ray and box.
pub fn ray_box(bounds: &BoundingBox, ray: &Ray, min_t: f64, max_t: f64) -> Option<f64> {
    // ANCHOR: answer
    let (mut enter, mut leave) = (min_t, max_t);
    for axis in 0..3 {
        let low = bounds.min[axis] - ray.origin[axis];
        let high = bounds.max[axis] - ray.origin[axis];
        let along = ray.direction[axis];
        if along == 0.0 {
            if low > 0.0 || high < 0.0 {
                return None;
            }
            continue;
        }
        let (a, b) = (low / along, high / along);
        enter = enter.max(a.min(b));
        leave = leave.min(a.max(b));
    }
    (enter <= leave).then_some(enter)
    // ANCHOR_END: answer
}
// ANCHOR_END: stub
