use pinhole::{BoundingBox, Triangle};

// ANCHOR: stub
/// The smallest box around a triangle whose faces are parallel to the axes.
///
/// Its `min` has the smallest x, the smallest y and the smallest z of the three corners,
/// its `max` the greatest of each. The box of a triangle that lies in a plane parallel to two
/// axes is flat.
///
/// Book: A box around it.
pub fn triangle_box(triangle: &Triangle) -> BoundingBox {
    todo!("triangle_box")
}
// ANCHOR_END: stub

// ANCHOR: stub_join
/// The smallest box around two boxes.
///
/// Book: A box around it.
pub fn join(a: &BoundingBox, b: &BoundingBox) -> BoundingBox {
    todo!("triangle_box")
}
// ANCHOR_END: stub_join
