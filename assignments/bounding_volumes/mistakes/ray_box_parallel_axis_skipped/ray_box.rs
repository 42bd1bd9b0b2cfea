use pinhole::{BoundingBox, Ray};

pub fn ray_box(bounds: &BoundingBox, ray: &Ray, min_t: f64, max_t: f64) -> Option<f64> {
    let (mut near, mut far) = (min_t, max_t);
    for axis in 0..3 {
        let along = ray.direction[axis];
        if along == 0.0 {
            continue;
        }
        let low = bounds.min[axis] - ray.origin[axis];
        let high = bounds.max[axis] - ray.origin[axis];
        let (a, b) = (low / along, high / along);
        near = near.max(a.min(b));
        far = far.min(a.max(b));
    }
    (near <= far).then_some(near)
}
