use pinhole::{BoundingBox, Tree};

pub fn build_tree(boxes: &[BoundingBox]) -> Tree {
    let all = Vec::from_iter(0..boxes.len());
    // Three times in two: eight lists.
    split(boxes, all, |a| {
        split(boxes, a, |b| split(boxes, b, Tree::Leaf))
    })
}

/// A branch over both sides of a list, or a leaf if it is short.
fn split(boxes: &[BoundingBox], list: Vec<usize>, child: impl Fn(Vec<usize>) -> Tree) -> Tree {
    if list.len() < 5 {
        return Tree::Leaf(list);
    }
    let ends = |axis: usize| {
        let along = list.iter().map(|&it| boxes[it].center()[axis]);
        let least = along.clone().fold(f64::INFINITY, f64::min);
        (least, along.fold(f64::NEG_INFINITY, f64::max))
    };
    let size = |axis: usize| ends(axis).1 - ends(axis).0;
    let axis = (1..3).fold(0, |a, b| if size(b) > size(a) { b } else { a });
    let middle = (ends(axis).0 + ends(axis).1) / 2.0;
    let half = list.len() / 2;
    let (mut left, mut right): (Vec<usize>, Vec<usize>) = list
        .iter()
        .partition(|&&it| boxes[it].center()[axis] < middle);
    if left.is_empty() || right.is_empty() {
        (left, right) = (list[..half].to_vec(), list[half..].to_vec());
    }
    Tree::Branch(Box::new([child(left), child(right)]))
}
