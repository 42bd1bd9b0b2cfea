use pinhole::{BoundingBox, Ray};

pub fn ray_box(bounds: &BoundingBox, ray: &Ray, min_t: f64, max_t: f64) -> Option<f64> {
    let (mut enter, mut leave) = (min_t, max_t);
    for axis in 0..3 {
        let (e, d) = (ray.origin[axis], ray.direction[axis]);
        let (first, last) = if d > 0.0 {
            (bounds.min[axis], bounds.max[axis])
        } else if d < 0.0 {
            (bounds.max[axis], bounds.min[axis])
        } else if e < bounds.min[axis] || e > bounds.max[axis] {
            return None;
        } else {
            continue;
        };
        let near = (first - e) / d;
        if near > enter {
            enter = near;
        }
        let far = (last - e) / d;
        if far < leave {
            leave = far;
        }
        if enter > leave {
            return None;
        }
    }
    Some(enter)
}
