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

/// Its volume.
fn size(bounds: &BoundingBox) -> f64 {
    let sides = bounds.max - bounds.min;
    sides.x * sides.y * sides.z
}

pub fn join(a: &BoundingBox, b: &BoundingBox) -> BoundingBox {
    let larger = [b, a]
        .into_iter()
        .max_by(|one, other| size(one).total_cmp(&size(other)));
    *larger.unwrap_or(a)
}
