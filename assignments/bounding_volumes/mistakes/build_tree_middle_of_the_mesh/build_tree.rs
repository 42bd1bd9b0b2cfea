use glam::DVec3;
use pinhole::{BoundingBox, Tree};

pub fn build_tree(boxes: &[BoundingBox]) -> Tree {
    let mut low = boxes[0].center();
    let mut high = low;
    for bounds in boxes {
        low = low.min(bounds.center());
        high = high.max(bounds.center());
    }
    grow(boxes, (0..boxes.len()).collect(), low, high)
}

fn grow(boxes: &[BoundingBox], triangles: Vec<usize>, low: DVec3, high: DVec3) -> Tree {
    if triangles.len() <= 4 {
        return Tree::Leaf(triangles);
    }
    let axis = (high - low).max_position();
    let middle = 0.5 * (low[axis] + high[axis]);
    let (mut left, mut right): (Vec<usize>, Vec<usize>) = triangles
        .into_iter()
        .partition(|&triangle| boxes[triangle].center()[axis] < middle);
    if left.is_empty() {
        left = right.drain(..right.len() / 2).collect();
    } else if right.is_empty() {
        right = left.split_off(left.len() / 2);
    }
    Tree::Branch(Box::new([
        grow(boxes, left, low, high),
        grow(boxes, right, low, high),
    ]))
}
