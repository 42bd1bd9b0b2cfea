use pinhole::{BoundingBox, Tree};

pub fn build_tree(boxes: &[BoundingBox]) -> Tree {
    split(boxes, (0..boxes.len()).collect())
}

fn split(boxes: &[BoundingBox], list: Vec<usize>) -> Tree {
    if list.len() <= 8 {
        return Tree::Leaf(list);
    }
    let places = |axis| list.iter().map(move |&it| boxes[it].center()[axis]);
    let least = |axis| places(axis).fold(f64::INFINITY, f64::min);
    let greatest = |axis| places(axis).fold(f64::NEG_INFINITY, f64::max);
    let length = |axis: &usize| greatest(*axis) - least(*axis);
    let axis = (0..3)
        .max_by(|a, b| length(a).total_cmp(&length(b)))
        .unwrap_or(0);
    let middle = (least(axis) + greatest(axis)) / 2.0;
    let goes_first = |it: &usize| boxes[*it].center()[axis] <= middle;
    let (mut first, mut rest): (Vec<usize>, Vec<usize>) =
        list.iter().copied().partition(goes_first);
    if rest.is_empty() {
        rest = first.split_off(first.len() / 2);
    }
    Tree::Branch(Box::new([split(boxes, first), split(boxes, rest)]))
}
