use pinhole::{BoundingBox, Ray};

pub fn ray_box(bounds: &BoundingBox, ray: &Ray, min_t: f64, max_t: f64) -> Option<f64> {
    let crossed = (0..3).filter(|&axis| ray.direction[axis] != 0.0);
    let (enter, leave) = crossed.fold((min_t, max_t), |(enter, leave), axis| {
        let t = |face: f64| (face - ray.origin[axis]) / ray.direction[axis];
        let mut slab = [t(bounds.min[axis]), t(bounds.max[axis])];
        if slab[0] > slab[1] {
            slab.reverse();
        }
        (enter.max(slab[0]), leave.min(slab[1]))
    });
    if enter > leave { None } else { Some(enter) }
}
