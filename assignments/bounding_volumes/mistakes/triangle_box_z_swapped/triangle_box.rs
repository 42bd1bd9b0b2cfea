use pinhole::{BoundingBox, Triangle};

pub fn triangle_box(triangle: &Triangle) -> BoundingBox {
    let [a, b, c] = triangle.corners;
    let (mut min, mut max) = (a.min(b).min(c), a.max(b).max(c));
    std::mem::swap(&mut min.z, &mut max.z);
    BoundingBox { min, max }
}

pub fn join(a: &BoundingBox, b: &BoundingBox) -> BoundingBox {
    BoundingBox {
        min: a.min.min(b.min),
        max: a.max.max(b.max),
    }
}
