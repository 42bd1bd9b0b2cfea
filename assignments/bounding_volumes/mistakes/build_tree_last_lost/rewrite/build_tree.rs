use pinhole::{BoundingBox, Tree};

pub fn build_tree(boxes: &[BoundingBox]) -> Tree {
    let mut list = Vec::new();
    let mut index = 0;
    while index + 1 < boxes.len() {
        list.push(index);
        index += 1;
    }
    subtree(boxes, list)
}

fn subtree(boxes: &[BoundingBox], list: Vec<usize>) -> Tree {
    if list.len() < 5 {
        return Tree::Leaf(list);
    }
    let extent = |axis: usize| {
        let along = list.iter().map(|&it| boxes[it].center()[axis]);
        let least = along.clone().fold(f64::INFINITY, f64::min);
        (least, along.fold(f64::NEG_INFINITY, f64::max))
    };
    let length = |axis: usize| extent(axis).1 - extent(axis).0;
    let longest = (1..3).fold(0, |a, b| if length(b) > length(a) { b } else { a });
    let split = (extent(longest).0 + extent(longest).1) / 2.0;
    let (mut left, mut right) = (Vec::new(), Vec::new());
    for it in list {
        let side = match boxes[it].center()[longest] < split {
            true => &mut left,
            false => &mut right,
        };
        side.push(it);
    }
    if left.is_empty() {
        left = right.drain(..right.len() / 2).collect();
    } else if right.is_empty() {
        right = left.split_off(left.len() / 2);
    }
    Tree::Branch(Box::new([subtree(boxes, left), subtree(boxes, right)]))
}
