use pinhole::{BoundingBox, Ray};

pub fn ray_box(bounds: &BoundingBox, ray: &Ray, min_t: f64, max_t: f64) -> Option<f64> {
    let inverse = ray.direction.recip().to_array();
    let (low, high) = (bounds.min - ray.origin, bounds.max - ray.origin);
    let (low, high) = (low.to_array(), high.to_array());
    let slabs = [0, 1, 2].map(|axis| [low[axis] * inverse[axis], high[axis] * inverse[axis]]);
    let enter = slabs.iter().fold(min_t, |t, [a, b]| t.max(a.min(*b)));
    let leave = slabs.iter().fold(max_t, |t, [a, b]| t.min(a.max(*b)));
    if leave >= enter { Some(enter) } else { None }
}
