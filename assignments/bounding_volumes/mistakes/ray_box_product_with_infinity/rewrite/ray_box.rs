use pinhole::{BoundingBox, Ray};

pub fn ray_box(bounds: &BoundingBox, ray: &Ray, min_t: f64, max_t: f64) -> Option<f64> {
    let slabs = [0, 1, 2].map(|axis| {
        let scale = ray.direction[axis].recip();
        let start = scale * ray.origin[axis];
        let [t, u] = [bounds.max, bounds.min].map(|face| scale.mul_add(face[axis], -start));
        [t.min(u), t.max(u)]
    });
    let mut t = [min_t, max_t];
    for [near, far] in slabs {
        if near > t[0] {
            t[0] = near;
        }
        if far < t[1] {
            t[1] = far;
        }
    }
    if t[0] > t[1] {
        return None;
    }
    Some(t[0])
}
