use pinhole::{BoundingBox, Tree};

pub fn build_tree(boxes: &[BoundingBox]) -> Tree {
    subtree(boxes, &Vec::from_iter(0..boxes.len()))
}

fn subtree(boxes: &[BoundingBox], part: &[usize]) -> Tree {
    if part.len() < 5 {
        return Tree::Leaf(part.to_vec());
    }
    let ends = |axis: usize| {
        let along = part.iter().map(|&it| boxes[it].center()[axis]);
        let least = along.clone().fold(f64::INFINITY, f64::min);
        (least, along.fold(f64::NEG_INFINITY, f64::max))
    };
    let size = |axis: usize| ends(axis).1 - ends(axis).0;
    let axis = (1..3).fold(0, |a, b| if size(b) > size(a) { b } else { a });
    let (least, most) = ends(axis);
    // How far to the right of the middle, twice.
    let beyond = |it: usize| 2.0 * boxes[it].center()[axis] - least - most;
    let side = |sign: f64| -> Vec<usize> {
        let all = part.iter().copied();
        all.filter(|&it| sign * beyond(it) > 0.0).collect()
    };
    let children = [-1.0, 1.0].map(side);
    Tree::Branch(Box::new(children.map(|child| subtree(boxes, &child))))
}
