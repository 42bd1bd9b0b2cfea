use pinhole::{BoundingBox, Tree};

// ANCHOR: stub
/// A binary tree over triangles, whose boxes are given in the mesh's order.
///
/// A leaf holds the places of its triangles in that list, counted from 0, and has at most 8
/// of them. Each triangle is in exactly one leaf.
///
/// Split a list at the middle of the longest axis of its boxes' centres: one child gets the
/// triangles whose centre lies on one side of it, the other child gets the rest. Where that
/// leaves one child without any triangle, halve the list instead. There is at least one
/// triangle.
///
/// Book: Building the tree.
pub fn build_tree(boxes: &[BoundingBox]) -> Tree {
    todo!("build_tree")
}
// ANCHOR_END: stub
