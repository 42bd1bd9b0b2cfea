use pinhole::{BoundingBox, Tree};

pub fn build_tree(boxes: &[BoundingBox]) -> Tree {
    subtree(boxes, &Vec::from_iter(0..boxes.len()))
}

fn subtree(boxes: &[BoundingBox], part: &[usize]) -> Tree {
    if part.len() < 5 {
        return Tree::Leaf(part.to_vec());
    }
    let range = |axis: usize| {
        let along = part.iter().map(|&it| boxes[it].center()[axis]);
        let least = along.clone().fold(f64::INFINITY, f64::min);
        (axis, least, along.fold(f64::NEG_INFINITY, f64::max))
    };
    let longer = |a: (usize, f64, f64), b: (usize, f64, f64)| match b.2 - b.1 > a.2 - a.1 {
        true => b,
        false => a,
    };
    let (axis, least, most) = longer(longer(range(0), range(1)), range(2));
    let split = (least + most) / 2.0;
    let chosen = |is_inside: &dyn Fn(&BoundingBox) -> bool| -> Vec<usize> {
        let all = part.iter().copied();
        all.filter(|&it| is_inside(&boxes[it])).collect()
    };
    let below = chosen(&|bounds| bounds.max[axis] < split);
    let above = chosen(&|bounds| bounds.min[axis] >= split);
    let halves = part.split_at(part.len() / 2);
    let (a, b) = match below.is_empty() || above.is_empty() {
        true => halves,
        false => (&below[..], &above[..]),
    };
    Tree::Branch(Box::new([subtree(boxes, a), subtree(boxes, b)]))
}
