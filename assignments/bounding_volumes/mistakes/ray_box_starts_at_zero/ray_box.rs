use pinhole::{BoundingBox, Ray};

pub fn ray_box(bounds: &BoundingBox, ray: &Ray, _min_t: f64, max_t: f64) -> Option<f64> {
    let (mut near, mut far) = (0.0_f64, max_t);
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
        near = near.max(a.min(b));
        far = far.min(a.max(b));
    }
    (near <= far).then_some(near)
}
