use pinhole::{BoundingBox, Ray};

/// Whether a point is in a solid box.
fn contains(bounds: &BoundingBox, ray: &Ray, t: f64) -> bool {
    let point = ray.at(t);
    point.cmpge(bounds.min).all() && point.cmple(bounds.max).all()
}

pub fn ray_box(bounds: &BoundingBox, ray: &Ray, min_t: f64, max_t: f64) -> Option<f64> {
    if contains(bounds, ray, min_t) {
        return Some(min_t);
    }
    let mut enter: Option<f64> = None;
    for axis in 0..3 {
        if ray.direction[axis] == 0.0 {
            continue;
        }
        for face in [bounds.min[axis], bounds.max[axis]] {
            let t = (face - ray.origin[axis]) / ray.direction[axis];
            let counts = t >= min_t && t <= max_t && contains(bounds, ray, t);
            if counts && enter.is_none_or(|nearest| t < nearest) {
                enter = Some(t);
            }
        }
    }
    enter
}
