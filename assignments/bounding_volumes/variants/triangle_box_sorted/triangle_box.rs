use pinhole::{BoundingBox, Triangle};

/// The smallest and the greatest of some coordinates.
fn ends<const N: usize>(mut coordinates: [f64; N]) -> (f64, f64) {
    coordinates.sort_by(f64::total_cmp);
    (coordinates[0], coordinates[N - 1])
}

pub fn triangle_box(triangle: &Triangle) -> BoundingBox {
    let [first, ..] = triangle.corners;
    let (mut min, mut max) = (first, first);
    for axis in 0..3 {
        (min[axis], max[axis]) = ends(triangle.corners.map(|corner| corner[axis]));
    }
    BoundingBox { min, max }
}

pub fn join(a: &BoundingBox, b: &BoundingBox) -> BoundingBox {
    let (mut min, mut max) = (a.min, a.max);
    for axis in 0..3 {
        (min[axis], max[axis]) = ends([a.min, a.max, b.min, b.max].map(|corner| corner[axis]));
    }
    BoundingBox { min, max }
}
