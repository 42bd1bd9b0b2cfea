use pinhole::{BoundingBox, Ray};

pub fn ray_box(bounds: &BoundingBox, ray: &Ray, min_t: f64, max_t: f64) -> Option<f64> {
    let (mut first, mut second) = (bounds.min, bounds.max);
    if ray.direction.x < 0.0 {
        std::mem::swap(&mut first, &mut second);
    }
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
        enter = enter.max((first[axis] - ray.origin[axis]) / along);
        leave = leave.min((second[axis] - ray.origin[axis]) / along);
    }
    (enter <= leave).then_some(enter)
}
