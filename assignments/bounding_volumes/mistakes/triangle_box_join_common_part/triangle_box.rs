use pinhole::{BoundingBox, Triangle};

pub fn triangle_box(triangle: &Triangle) -> BoundingBox {
    let [a, b, c] = triangle.corners;
    BoundingBox {
        min: a.min(b).min(c),
        max: a.max(b).max(c),
    }
}

pub fn join(a: &BoundingBox, b: &BoundingBox) -> BoundingBox {
    BoundingBox {
        min: a.min.max(b.min),
        max: a.max.min(b.max),
    }
}
