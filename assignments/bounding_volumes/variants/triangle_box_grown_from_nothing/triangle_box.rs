use glam::DVec3;
use pinhole::{BoundingBox, Triangle};

/// The smallest box around points.
fn around(points: &[DVec3]) -> BoundingBox {
    let of = |axis: usize| points.iter().map(move |point| point[axis]);
    let least = |axis| of(axis).fold(f64::INFINITY, f64::min);
    let most = |axis| of(axis).fold(f64::NEG_INFINITY, f64::max);
    BoundingBox {
        min: DVec3::new(least(0), least(1), least(2)),
        max: DVec3::new(most(0), most(1), most(2)),
    }
}

pub fn triangle_box(triangle: &Triangle) -> BoundingBox {
    around(&triangle.corners)
}

pub fn join(a: &BoundingBox, b: &BoundingBox) -> BoundingBox {
    around(&[a.min, a.max, b.min, b.max])
}
