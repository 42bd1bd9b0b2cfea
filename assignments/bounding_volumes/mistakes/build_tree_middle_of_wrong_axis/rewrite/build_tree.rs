use pinhole::{BoundingBox, Tree};

pub fn build_tree(boxes: &[BoundingBox]) -> Tree {
    subtree(boxes, &Vec::from_iter(0..boxes.len()))
}

fn subtree(boxes: &[BoundingBox], part: &[usize]) -> Tree {
    if part.len() < 5 {
        return Tree::Leaf(part.to_vec());
    }
    let split = split(boxes, part);
    let x = |it: usize| 0.5 * (boxes[it].min.x + boxes[it].max.x);
    let mut order = part.to_vec();
    // The left ones first, in the same order as before.
    order.sort_by_key(|&it| x(it) >= split);
    let place = match order.partition_point(|&it| x(it) < split) {
        0 => order.len() / 2,
        all if all == order.len() => all / 2,
        place => place,
    };
    let (a, b) = order.split_at(place);
    Tree::Branch(Box::new([subtree(boxes, a), subtree(boxes, b)]))
}

/// The middle of the longest axis.
fn split(boxes: &[BoundingBox], order: &[usize]) -> f64 {
    let ends = [0, 1, 2].map(|axis| {
        let along = order.iter().map(|&it| boxes[it].center()[axis]);
        let least = along.clone().fold(f64::INFINITY, f64::min);
        (least, along.fold(f64::NEG_INFINITY, f64::max))
    });
    let mut longest = ends[0];
    for (least, most) in ends {
        if most - least > longest.1 - longest.0 {
            longest = (least, most);
        }
    }
    (longest.0 + longest.1) / 2.0
}
