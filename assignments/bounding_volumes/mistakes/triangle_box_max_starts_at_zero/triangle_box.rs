use glam::DVec3;
use pinhole::{BoundingBox, Triangle};

pub fn triangle_box(triangle: &Triangle) -> BoundingBox {
    let mut min = DVec3::INFINITY;
    let mut max = DVec3::ZERO;
    for corner in triangle.corners {
        min = min.min(corner);
        max = max.max(corner);
    }
    BoundingBox { min, max }
}

pub fn join(a: &BoundingBox, b: &BoundingBox) -> BoundingBox {
    BoundingBox {
        min: a.min.min(b.min),
        max: a.max.max(b.max),
    }
}
