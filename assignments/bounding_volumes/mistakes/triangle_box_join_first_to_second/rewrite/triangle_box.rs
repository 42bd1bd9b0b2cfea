use pinhole::{BoundingBox, Triangle};

pub fn triangle_box(triangle: &Triangle) -> BoundingBox {
    let [first, rest @ ..] = triangle.corners;
    let mut bounds = BoundingBox {
        min: first,
        max: first,
    };
    for corner in rest {
        bounds.min = bounds.min.min(corner);
        bounds.max = bounds.max.max(corner);
    }
    bounds
}

pub fn join(a: &BoundingBox, b: &BoundingBox) -> BoundingBox {
    let mut both = *b;
    for axis in 0..3 {
        both.min[axis] = a.min[axis];
    }
    both
}
