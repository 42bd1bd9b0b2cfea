use pinhole::{BoundingBox, Tree};

pub fn build_tree(boxes: &[BoundingBox]) -> Tree {
    subtree(boxes, &Vec::from_iter(0..boxes.len()))
}

fn subtree(boxes: &[BoundingBox], part: &[usize]) -> Tree {
    let is_small = part.len() >> 4 == 0 || part.len() == 16;
    if is_small {
        return Tree::Leaf(part.to_vec());
    }
    let ends = |axis: usize| {
        let along = part.iter().map(|&it| boxes[it].center()[axis]);
        let least = along.clone().fold(f64::INFINITY, f64::min);
        [least, along.fold(f64::NEG_INFINITY, f64::max)]
    };
    let size = |axis: usize| ends(axis)[1] - ends(axis)[0];
    let axis = (1..3).fold(0, |a, b| if size(b) > size(a) { b } else { a });
    let split = ends(axis).iter().sum::<f64>() / 2.0;
    let is_left = |it: &usize| boxes[*it].center()[axis] < split;
    let (mut left, mut right): (Vec<usize>, Vec<usize>) = part.iter().partition(|it| is_left(it));
    if left.is_empty() || right.is_empty() {
        left = part[..part.len() / 2].to_vec();
        right = part[part.len() / 2..].to_vec();
    }
    Tree::Branch(Box::new([&left, &right].map(|side| subtree(boxes, side))))
}
