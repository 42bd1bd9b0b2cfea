use glam::DVec3;
use pinhole::{BoundingBox, Triangle};

pub fn triangle_box(triangle: &Triangle) -> BoundingBox {
    let points = triangle.corners.map(|corner| BoundingBox {
        min: corner,
        max: corner,
    });
    join(&join(&points[0], &points[1]), &points[2])
}

pub fn join(a: &BoundingBox, b: &BoundingBox) -> BoundingBox {
    BoundingBox {
        min: DVec3::select(a.min.cmple(b.min), a.min, b.min),
        max: DVec3::select(a.max.cmpge(b.max), a.max, b.max),
    }
}
