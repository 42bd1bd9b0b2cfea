use glam::DVec3;
use pinhole::{BoundingBox, Triangle};

/// Half of a flat box's thickness.
const PADDING: f64 = 1e-4;

pub fn triangle_box(triangle: &Triangle) -> BoundingBox {
    let [a, b, c] = triangle.corners;
    let (min, max) = (a.min(b).min(c), a.max(b).max(c));
    let flat = min.cmpeq(max);
    let padding = DVec3::select(flat, DVec3::splat(PADDING), DVec3::ZERO);
    BoundingBox {
        min: min - padding,
        max: max + padding,
    }
}

pub fn join(a: &BoundingBox, b: &BoundingBox) -> BoundingBox {
    BoundingBox {
        min: a.min.min(b.min),
        max: a.max.max(b.max),
    }
}
