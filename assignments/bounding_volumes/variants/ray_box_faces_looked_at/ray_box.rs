use pinhole::{BoundingBox, Ray};

pub fn ray_box(bounds: &BoundingBox, ray: &Ray, min_t: f64, max_t: f64) -> Option<f64> {
    let is_within = |t: f64, axis: usize| {
        let x = ray.origin[axis] + t * ray.direction[axis];
        bounds.min[axis] <= x && x <= bounds.max[axis]
    };
    if (0..3).all(|axis| is_within(min_t, axis)) {
        return Some(min_t);
    }
    (0..3).find_map(|axis| {
        let d = ray.direction[axis];
        let face = if d > 0.0 { bounds.min } else { bounds.max };
        let t = (face[axis] - ray.origin[axis]) / d;
        let counts = d != 0.0 && min_t <= t && t <= max_t;
        let mut others = (0..3).filter(|&other| other != axis);
        (counts && others.all(|other| is_within(t, other))).then_some(t)
    })
}
