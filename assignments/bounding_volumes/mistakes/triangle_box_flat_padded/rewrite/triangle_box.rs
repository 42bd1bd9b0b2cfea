use pinhole::{BoundingBox, Triangle};

pub fn triangle_box(triangle: &Triangle) -> BoundingBox {
    let mut bounds = BoundingBox {
        min: triangle.corners[0],
        max: triangle.corners[0],
    };
    for axis in 0..3 {
        let mut sorted = triangle.corners.map(|corner| corner[axis]);
        sorted.sort_by(f64::total_cmp);
        let [low, _, high] = sorted;
        let middle = 0.5 * (low + high);
        if high - low < 1e-4 {
            bounds.min[axis] = middle - 0.00005;
            bounds.max[axis] = middle + 0.00005;
        } else {
            bounds.min[axis] = low;
            bounds.max[axis] = high;
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
