use pinhole::{BoundingBox, Tree};

pub fn build_tree(boxes: &[BoundingBox]) -> Tree {
    subtree(boxes, &Vec::from_iter(0..boxes.len()))
}

fn subtree(boxes: &[BoundingBox], part: &[usize]) -> Tree {
    if part.len() < 5 {
        return Tree::Leaf(part.to_vec());
    }
    let length = |axis: usize| {
        let along = part.iter().map(|&it| boxes[it].center()[axis]);
        let least = along.clone().fold(f64::INFINITY, f64::min);
        along.fold(f64::NEG_INFINITY, f64::max) - least
    };
    let lengths = [0, 1, 2].map(length);
    let axis = (1..3).fold(0, |a, b| if lengths[b] > lengths[a] { b } else { a });
    let is_left = |it: &usize| 2.0 * boxes[*it].center()[axis] < lengths[axis];
    let mut order: Vec<usize> = part.iter().copied().filter(is_left).collect();
    let mut place = order.len();
    order.extend(part.iter().filter(|it| !is_left(it)));
    if place == 0 || place == part.len() {
        place = part.len() / 2;
    }
    let (a, b) = order.split_at(place);
    Tree::Branch(Box::new([subtree(boxes, a), subtree(boxes, b)]))
}
