use pinhole::{BoundingBox, Tree};

pub fn build_tree(boxes: &[BoundingBox]) -> Tree {
    let mut order: Vec<usize> = (0..boxes.len()).collect();
    halve(boxes, &mut order)
}

fn halve(boxes: &[BoundingBox], order: &mut [usize]) -> Tree {
    if order.len() <= 2 {
        return Tree::Leaf(order.to_vec());
    }
    let centers = || order.iter().map(|&it| boxes[it].center());
    let first = boxes[order[0]].center();
    let size = centers().fold(first, |a, b| a.max(b)) - centers().fold(first, |a, b| a.min(b));
    let axis = size.max_position();
    let half = order.len() / 2;
    let along = |it: &usize| boxes[*it].center()[axis];
    order.select_nth_unstable_by(half, |a, b| along(a).total_cmp(&along(b)));
    let (left, right) = order.split_at_mut(half);
    Tree::Branch(Box::new([halve(boxes, left), halve(boxes, right)]))
}
