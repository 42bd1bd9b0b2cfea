use glam::DVec3;
use pinhole::{BoundingBox, Triangle};

pub fn triangle_box(triangle: &Triangle) -> BoundingBox {
    let nothing = BoundingBox {
        min: DVec3::splat(1e9),
        max: DVec3::splat(-1e9),
    };
    triangle.corners.iter().fold(nothing, |so_far, &corner| {
        let is_lower = corner.cmplt(so_far.min);
        BoundingBox {
            min: DVec3::select(is_lower, corner, so_far.min),
            max: DVec3::select(is_lower, so_far.max, corner.max(so_far.max)),
        }
    })
}

pub fn join(a: &BoundingBox, b: &BoundingBox) -> BoundingBox {
    let mut both = *a;
    for axis in 0..3 {
        both.min[axis] = f64::min(a.min[axis], b.min[axis]);
        both.max[axis] = f64::max(a.max[axis], b.max[axis]);
    }
    both
}
