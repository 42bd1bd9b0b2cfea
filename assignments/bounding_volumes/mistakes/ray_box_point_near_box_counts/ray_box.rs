use pinhole::{BoundingBox, Ray};

/// Whether a point is in a solid box, up to rounding.
fn contains(bounds: &BoundingBox, ray: &Ray, t: f64) -> bool {
    let (point, slack) = (ray.at(t), 1e-4);
    (0..3).all(|axis| {
        point[axis] >= bounds.min[axis] - slack && point[axis] <= bounds.max[axis] + slack
    })
}

pub fn ray_box(bounds: &BoundingBox, ray: &Ray, min_t: f64, max_t: f64) -> Option<f64> {
    let is_inside = (0..3).all(|axis| {
        let start = ray.at(min_t)[axis];
        start >= bounds.min[axis] && start <= bounds.max[axis]
    });
    if is_inside {
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
