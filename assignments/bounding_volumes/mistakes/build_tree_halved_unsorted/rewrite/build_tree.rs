use std::ops::Range;

use pinhole::{BoundingBox, Tree};

pub fn build_tree(boxes: &[BoundingBox]) -> Tree {
    subtree(0..boxes.len())
}

/// The tree over the triangles from `range.start` to `range.end` in the mesh's order.
fn subtree(range: Range<usize>) -> Tree {
    match range.len() {
        0..=4 => Tree::Leaf(range.collect()),
        count => {
            let half = range.start + count / 2;
            let children = [range.start..half, half..range.end];
            Tree::Branch(Box::new(children.map(subtree)))
        }
    }
}
