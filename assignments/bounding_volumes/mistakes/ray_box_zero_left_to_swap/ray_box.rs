use pinhole::{BoundingBox, Ray};

pub fn ray_box(bounds: &BoundingBox, ray: &Ray, min_t: f64, max_t: f64) -> Option<f64> {
    let (mut enter, mut leave) = (min_t, max_t);
    for axis in 0..3 {
        let mut a = (bounds.min[axis] - ray.origin[axis]) / ray.direction[axis];
        let mut b = (bounds.max[axis] - ray.origin[axis]) / ray.direction[axis];
        if a > b {
            std::mem::swap(&mut a, &mut b);
        }
        if a > enter {
            enter = a;
        }
        if b < leave {
            leave = b;
        }
        if enter > leave {
            return None;
        }
    }
    Some(enter)
}
