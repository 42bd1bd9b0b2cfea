use glam::DVec3;
use pinhole::{BoundingBox, Triangle};

pub fn triangle_box(triangle: &Triangle) -> BoundingBox {
    let greatest = |axis: usize| {
        let coordinates = triangle.corners.iter().map(|corner| corner[axis]);
        coordinates.fold(f64::MIN_POSITIVE, f64::max)
    };
    let [a, b, c] = triangle.corners;
    BoundingBox {
        min: a.min(b.min(c)),
        max: DVec3::new(greatest(0), greatest(1), greatest(2)),
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
