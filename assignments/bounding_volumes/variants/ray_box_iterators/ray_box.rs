use pinhole::{BoundingBox, Ray};

/// The t from which and up to which a ray is in the slab of an axis.
fn slab(bounds: &BoundingBox, ray: &Ray, axis: usize) -> (f64, f64) {
    let (e, d) = (ray.origin[axis], ray.direction[axis]);
    let (low, high) = (bounds.min[axis], bounds.max[axis]);
    if d != 0.0 {
        let (a, b) = ((low - e) / d, (high - e) / d);
        (a.min(b), a.max(b))
    } else if (low..=high).contains(&e) {
        (f64::NEG_INFINITY, f64::INFINITY)
    } else {
        (f64::INFINITY, f64::NEG_INFINITY)
    }
}

pub fn ray_box(bounds: &BoundingBox, ray: &Ray, min_t: f64, max_t: f64) -> Option<f64> {
    let slabs = [0, 1, 2].map(|axis| slab(bounds, ray, axis));
    let entries = slabs.iter().map(|(near, _)| *near).chain([min_t]);
    let exits = slabs.iter().map(|(_, far)| *far).chain([max_t]);
    let enter = entries.reduce(f64::max)?;
    let leave = exits.reduce(f64::min)?;
    (enter <= leave).then_some(enter)
}
