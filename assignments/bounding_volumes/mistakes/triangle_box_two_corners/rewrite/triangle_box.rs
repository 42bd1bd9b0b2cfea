use pinhole::{BoundingBox, Triangle};

pub fn triangle_box(triangle: &Triangle) -> BoundingBox {
    let mut bounds = BoundingBox {
        min: triangle.corners[0],
        max: triangle.corners[0],
    };
    for axis in 0..3 {
        for place in 1..triangle.corners.len() - 1 {
            let coordinate = triangle.corners[place][axis];
            if coordinate < bounds.min[axis] {
                bounds.min[axis] = coordinate;
            }
            if coordinate > bounds.max[axis] {
                bounds.max[axis] = coordinate;
            }
        }
    }
    bounds
}

pub fn join(a: &BoundingBox, b: &BoundingBox) -> BoundingBox {
    let mut both = *a;
    for axis in 0..3 {
        both.min[axis] = f64::min(a.min[axis], b.min[axis]);
        both.max[axis] = f64::max(a.max[axis], b.max[axis]);
    }
    both
}
