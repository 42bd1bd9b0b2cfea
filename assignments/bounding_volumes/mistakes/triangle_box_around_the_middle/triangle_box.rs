use pinhole::{BoundingBox, Triangle};

pub fn triangle_box(triangle: &Triangle) -> BoundingBox {
    let [a, b, c] = triangle.corners;
    let middle = (a + b + c) / 3.0;
    let [to_a, to_b, to_c] = triangle.corners.map(|corner| (corner - middle).abs());
    let reach = to_a.max(to_b).max(to_c);
    BoundingBox {
        min: middle - reach,
        max: middle + reach,
    }
}

pub fn join(a: &BoundingBox, b: &BoundingBox) -> BoundingBox {
    BoundingBox {
        min: a.min.min(b.min),
        max: a.max.max(b.max),
    }
}
