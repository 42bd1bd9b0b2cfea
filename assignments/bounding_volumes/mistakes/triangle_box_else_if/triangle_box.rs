use glam::DVec3;
use pinhole::{BoundingBox, Triangle};

pub fn triangle_box(triangle: &Triangle) -> BoundingBox {
    let (mut min, mut max) = (DVec3::splat(1e9), DVec3::splat(-1e9));
    for corner in triangle.corners {
        for axis in 0..3 {
            if corner[axis] < min[axis] {
                min[axis] = corner[axis];
            } else if corner[axis] > max[axis] {
                max[axis] = corner[axis];
            }
        }
    }
    BoundingBox { min, max }
}

pub fn join(a: &BoundingBox, b: &BoundingBox) -> BoundingBox {
    BoundingBox {
        min: a.min.min(b.min),
        max: a.max.max(b.max),
    }
}
