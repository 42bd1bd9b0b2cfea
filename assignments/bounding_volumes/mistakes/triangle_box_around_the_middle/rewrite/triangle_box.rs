use pinhole::{BoundingBox, Triangle};

pub fn triangle_box(triangle: &Triangle) -> BoundingBox {
    let mut bounds = BoundingBox {
        min: triangle.corners[0],
        max: triangle.corners[0],
    };
    for axis in 0..3 {
        let coordinates = triangle.corners.map(|corner| corner[axis]);
        let mean = coordinates.iter().sum::<f64>() / 3.0;
        let mut radius: f64 = 0.0;
        for coordinate in coordinates {
            radius = radius.max((coordinate - mean).abs());
        }
        (bounds.min[axis], bounds.max[axis]) = (mean - radius, mean + radius);
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
