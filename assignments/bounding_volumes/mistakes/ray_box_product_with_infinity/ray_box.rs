use pinhole::{BoundingBox, Ray};

pub fn ray_box(bounds: &BoundingBox, ray: &Ray, min_t: f64, max_t: f64) -> Option<f64> {
    let (mut enter, mut leave) = (min_t, max_t);
    for axis in 0..3 {
        let inverse = 1.0 / ray.direction[axis];
        let shift = ray.origin[axis] * inverse;
        let a = bounds.min[axis] * inverse - shift;
        let b = bounds.max[axis] * inverse - shift;
        enter = enter.max(a.min(b));
        leave = leave.min(a.max(b));
    }
    (enter <= leave).then_some(enter)
}
