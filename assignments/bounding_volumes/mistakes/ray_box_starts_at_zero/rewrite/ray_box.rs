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

pub fn ray_box(bounds: &BoundingBox, ray: &Ray, _min_t: f64, max_t: f64) -> Option<f64> {
    let mut slabs = Vec::new();
    for axis in 0..3 {
        let faces = [bounds.min[axis], bounds.max[axis]];
        slabs.push(slab(faces, ray.origin[axis], ray.direction[axis])?);
    }
    let near = slabs
        .iter()
        .map(|slab| slab[0])
        .fold(f64::NEG_INFINITY, f64::max);
    let far = slabs
        .iter()
        .map(|slab| slab[1])
        .fold(f64::INFINITY, f64::min);
    if near > far || far < 0.0 || near > max_t {
        return None;
    }
    Some(if near < 0.0 { 0.0 } else { near })
}
