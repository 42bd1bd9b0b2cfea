use pinhole::{BoundingBox, Tree};

// ANCHOR: stub
/// A binary tree over triangles, whose boxes are given in the mesh's order.
///
/// A leaf holds at most 8 triangles, by their places in that list, counted from 0. Each
/// triangle is in exactly one leaf.
///
/// To split a list, find the axis along which its boxes' centres spread most, and cut in the
/// middle between the least and the greatest centre: one child gets the triangles whose
/// centre lies on one side of the cut, the other child gets the rest. If that leaves one
/// child without a triangle, halve the list instead. `boxes` is never empty.
///
/// Book: Building the tree.
pub fn build_tree(boxes: &[BoundingBox]) -> Tree {
    todo!("build_tree")
}
// ANCHOR_END: stub
