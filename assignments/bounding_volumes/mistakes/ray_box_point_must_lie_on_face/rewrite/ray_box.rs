use pinhole::{BoundingBox, Ray};

pub fn ray_box(bounds: &BoundingBox, ray: &Ray, min_t: f64, max_t: f64) -> Option<f64> {
    let corners = [bounds.min, bounds.max];
    let axes = (0..3).filter(|&axis| ray.direction[axis] != 0.0);
    let faces = axes.flat_map(|axis| corners.map(|corner| (axis, corner[axis])));
    let mut met: Vec<f64> = faces
        .map(|(axis, face)| (face - ray.origin[axis]) / ray.direction[axis])
        .filter(|t| (min_t..=max_t).contains(t))
        .collect();
    met.push(min_t);
    met.sort_by(f64::total_cmp);
    met.into_iter().find(|t| {
        let point = ray.origin + ray.direction * *t;
        point == point.clamp(bounds.min, bounds.max)
    })
}
