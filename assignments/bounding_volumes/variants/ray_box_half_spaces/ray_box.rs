use pinhole::{BoundingBox, Ray};

pub fn ray_box(bounds: &BoundingBox, ray: &Ray, min_t: f64, max_t: f64) -> Option<f64> {
    let (mut enter, mut leave) = (min_t, max_t);
    for axis in 0..3 {
        for (face, outward) in [(bounds.min[axis], -1.0), (bounds.max[axis], 1.0)] {
            // How far outside the ray's origin is, and how fast the ray goes outwards.
            let outside = outward * (ray.origin[axis] - face);
            let speed = outward * ray.direction[axis];
            if speed < 0.0 {
                enter = enter.max(outside / -speed);
            } else if speed > 0.0 {
                leave = leave.min(-outside / speed);
            } else if outside > 0.0 {
                return None;
            }
        }
    }
    (enter <= leave).then_some(enter)
}
