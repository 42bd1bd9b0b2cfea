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
    let mut common = *a;
    for axis in 0..3 {
        if b.min[axis] > common.min[axis] {
            common.min[axis] = b.min[axis];
        }
        if b.max[axis] < common.max[axis] {
            common.max[axis] = b.max[axis];
        }
    }
    common
}
