use glam::DVec3;
use pinhole::{BoundingBox, Triangle};

pub fn triangle_box(triangle: &Triangle) -> BoundingBox {
    let sorted = |axis: usize| {
        let mut coordinates = triangle.corners.map(|corner| corner[axis]);
        coordinates.sort_by(f64::total_cmp);
        coordinates
    };
    let (x, y, depth) = (sorted(0), sorted(1), sorted(2));
    BoundingBox {
        min: DVec3::new(x[0], y[0], depth[2]),
        max: DVec3::new(x[2], y[2], depth[0]),
    }
}

pub fn join(a: &BoundingBox, b: &BoundingBox) -> BoundingBox {
    let mut both = *a;
    for axis in 0..3 {
        both.min[axis] = f64::min(a.min[axis], b.min[axis]);
        both.max[axis] = f64::max(a.max[axis], b.max[axis]);
    }
    both
}
