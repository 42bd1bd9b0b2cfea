use pinhole::{BoundingBox, Ray};

/// Tests the slabs from `axis` on; `found` is where the ray enters the one before.
fn test(bounds: &BoundingBox, ray: &Ray, t: [f64; 2], axis: usize, found: f64) -> Option<f64> {
    if axis == 3 {
        return Some(found);
    }
    let (e, d) = (ray.origin[axis], ray.direction[axis]);
    let faces = [bounds.min[axis], bounds.max[axis]];
    let enters = if d == 0.0 {
        (faces[0] <= e && e <= faces[1]).then_some(found)
    } else {
        let met = faces.map(|face| (face - e) / d);
        let enter = met[0].min(met[1]).max(t[0]);
        (enter <= met[0].max(met[1]).min(t[1])).then_some(enter)
    };
    test(bounds, ray, t, axis + 1, enters?)
}

pub fn ray_box(bounds: &BoundingBox, ray: &Ray, min_t: f64, max_t: f64) -> Option<f64> {
    test(bounds, ray, [min_t, max_t], 0, min_t)
}
