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
    let mut both = *a;
    for axis in 0..3 {
        if b.min[axis] < both.min[axis] {
            both.min[axis] = b.min[axis];
        }
    }
    if b.max.x > both.max.x {
        both.max.x = b.max.x;
    }
    if b.max.y > both.max.y {
        both.max.y = b.max.y;
    }
    if a.max.z > both.max.z {
        both.max.z = a.max.z;
    }
    both
}
