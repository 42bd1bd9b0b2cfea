use pinhole::{BoundingBox, Tree};

pub fn build_tree(boxes: &[BoundingBox]) -> Tree {
    subtree(boxes, &Vec::from_iter(0..boxes.len()))
}

fn subtree(boxes: &[BoundingBox], part: &[usize]) -> Tree {
    if part.len() < 5 {
        return Tree::Leaf(part.to_vec());
    }
    let (mut least, mut most) = (f64::INFINITY, f64::NEG_INFINITY);
    for &it in part {
        let x = 0.5 * (boxes[it].min.x + boxes[it].max.x);
        least = least.min(x);
        most = most.max(x);
    }
    let is_left = |it: &usize| boxes[*it].min.x + boxes[*it].max.x < least + most;
    let (mut left, mut right): (Vec<_>, Vec<_>) = part.iter().copied().partition(is_left);
    if left.is_empty() || right.is_empty() {
        let (a, b) = part.split_at(part.len() / 2);
        (left, right) = (a.to_vec(), b.to_vec());
    }
    Tree::Branch(Box::new([subtree(boxes, &left), subtree(boxes, &right)]))
}
