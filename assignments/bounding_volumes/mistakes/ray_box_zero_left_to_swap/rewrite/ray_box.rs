use pinhole::{BoundingBox, Ray};

pub fn ray_box(bounds: &BoundingBox, ray: &Ray, min_t: f64, max_t: f64) -> Option<f64> {
    let slabs = [0, 1, 2].map(|axis| {
        let inverse = ray.direction[axis].recip();
        let t = inverse * (bounds.min[axis] - ray.origin[axis]);
        let u = inverse * (bounds.max[axis] - ray.origin[axis]);
        if t > u { [u, t] } else { [t, u] }
    });
    let mut first = min_t;
    let mut last = max_t;
    for [near, far] in slabs {
        first = if first < near { near } else { first };
        last = if far < last { far } else { last };
    }
    if last < first { None } else { Some(first) }
}
