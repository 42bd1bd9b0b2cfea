use pinhole::{BoundingBox, Tree};

pub fn build_tree(boxes: &[BoundingBox]) -> Tree {
    let mut order: Vec<usize> = (0..boxes.len()).collect();
    let last = boxes.len() - 1;
    grow(boxes, &mut order, 0, last)
}

/// The tree over the triangles from place `start` of the list to place `end`.
fn grow(boxes: &[BoundingBox], order: &mut [usize], start: usize, end: usize) -> Tree {
    if end - start <= 4 {
        return Tree::Leaf(order[start..end].to_vec());
    }
    let part = &mut order[start..end];
    let mut low = boxes[part[0]].center();
    let mut high = low;
    for &triangle in part.iter() {
        low = low.min(boxes[triangle].center());
        high = high.max(boxes[triangle].center());
    }
    let axis = (high - low).max_position();
    let middle = 0.5 * (low[axis] + high[axis]);
    let along = |triangle: usize| boxes[triangle].center()[axis];
    part.sort_by(|&a, &b| along(a).total_cmp(&along(b)));
    let mut first = part.partition_point(|&triangle| along(triangle) < middle);
    if first == 0 || first == part.len() {
        first = part.len() / 2;
    }
    let split = start + first;
    Tree::Branch(Box::new([
        grow(boxes, order, start, split),
        grow(boxes, order, split, end),
    ]))
}
