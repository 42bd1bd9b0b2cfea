use pinhole::{BoundingBox, Ray};

pub fn ray_box(bounds: &BoundingBox, ray: &Ray, min_t: f64, max_t: f64) -> Option<f64> {
    let mut met = Vec::new();
    for axis in 0..3 {
        let (e, d) = (ray.origin[axis], ray.direction[axis]);
        let (low, high) = (bounds.min[axis], bounds.max[axis]);
        if d != 0.0 {
            met.extend([(low - e) / d, (high - e) / d]);
        } else if e < low || e > high {
            return None;
        }
    }
    met.sort_by(f64::total_cmp);
    let (first, last) = (met.first()?, met.last()?);
    let t = first.max(min_t);
    if *last < t || t > max_t {
        None
    } else {
        Some(t)
    }
}
