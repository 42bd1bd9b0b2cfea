use pinhole::{BoundingBox, Tree};

pub fn build_tree(boxes: &[BoundingBox]) -> Tree {
    if boxes.len() <= 4 {
        return Tree::Leaf((0..boxes.len()).collect());
    }
    let mut low = boxes[0].center();
    let mut high = low;
    for bounds in boxes {
        low = low.min(bounds.center());
        high = high.max(bounds.center());
    }
    let axis = (high - low).max_position();
    let middle = 0.5 * (low[axis] + high[axis]);
    let (mut left, mut right): (Vec<BoundingBox>, Vec<BoundingBox>) = boxes
        .iter()
        .partition(|bounds| bounds.center()[axis] < middle);
    if left.is_empty() || right.is_empty() {
        left = boxes.to_vec();
        right = left.split_off(boxes.len() / 2);
    }
    Tree::Branch(Box::new([build_tree(&left), build_tree(&right)]))
}
