use pinhole::{BoundingBox, Triangle};

pub fn triangle_box(triangle: &Triangle) -> BoundingBox {
    let [a, b, _] = triangle.corners;
    BoundingBox {
        min: a.min(b),
        max: a.max(b),
    }
}

pub fn join(a: &BoundingBox, b: &BoundingBox) -> BoundingBox {
    BoundingBox {
        min: a.min.min(b.min),
        max: a.max.max(b.max),
    }
}
