use pinhole::{BoundingBox, Ray};

/// The t between which a coordinate lies between two faces. `None` if it never does.
fn slab(faces: [f64; 2], origin: f64, direction: f64) -> Option<[f64; 2]> {
    if direction == 0.0 {
        let between = faces[0] <= origin && origin <= faces[1];
        return between.then_some([f64::NEG_INFINITY, f64::INFINITY]);
    }
    let mut met = faces.map(|face| (face - origin) / direction);
    met.sort_by(f64::total_cmp);
    Some(met)
}

pub fn ray_box(bounds: &BoundingBox, ray: &Ray, min_t: f64, max_t: f64) -> Option<f64> {
    let (min, max, e, d) = (bounds.min, bounds.max, ray.origin, ray.direction);
    let x = slab([min.x, max.x], e.x, d.x)?;
    let y = slab([min.y, max.y], e.y, d.y)?;
    let z = slab([min.z, max.z], e.z, d.y)?;
    let enter = x[0].max(y[0]).max(z[0]).max(min_t);
    let leave = x[1].min(y[1]).min(z[1]).min(max_t);
    (enter <= leave).then_some(enter)
}
