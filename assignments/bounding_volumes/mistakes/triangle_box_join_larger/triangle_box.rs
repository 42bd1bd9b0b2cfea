use pinhole::{BoundingBox, Triangle};

pub fn triangle_box(triangle: &Triangle) -> BoundingBox {
    let [a, b, c] = triangle.corners;
    BoundingBox {
        min: a.min(b).min(c),
        max: a.max(b).max(c),
    }
}

pub fn join(a: &BoundingBox, b: &BoundingBox) -> BoundingBox {
    let volume = |bounds: &BoundingBox| (bounds.max - bounds.min).element_product();
    if volume(a) >= volume(b) { *a } else { *b }
}
