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
    let e = ray.origin;
    let d = ray.direction;
    let [left, right] = slab([bounds.min.x, bounds.max.x], e.x, d.x)?;
    let [bottom, top] = slab([bounds.min.y, bounds.max.y], e.y, d.y)?;
    let enter = left.max(bottom).max(min_t);
    let leave = right.min(top).min(max_t);
    if enter <= leave { Some(enter) } else { None }
}
