use pinhole::{BoundingBox, Tree};

// ANCHOR: stub
/// A binary tree over triangles, whose boxes are given in the mesh's order.
///
/// A leaf holds at most 8 triangles, by their places in that list, counted from 0. Each
/// triangle is in exactly one leaf.
///
/// Split a list at the middle of the longest axis of its boxes' centres: one child gets the
/// triangles whose centre lies on one side of it, the other child gets the rest. If that
/// leaves one child without a triangle, halve the list instead. `boxes` is never empty.
///
/// Book: Building the tree.
pub fn build_tree(boxes: &[BoundingBox]) -> Tree {
    todo!("build_tree")
}
// ANCHOR_END: stub
