use pinhole::{BoundingBox, Tree};

pub fn build_tree(boxes: &[BoundingBox]) -> Tree {
    let mut order: Vec<usize> = (0..boxes.len()).collect();
    subtree(boxes, &mut order)
}

fn subtree(boxes: &[BoundingBox], order: &mut [usize]) -> Tree {
    if order.len() < 5 {
        let places = order.iter().enumerate().map(|(place, _)| place);
        return Tree::Leaf(places.collect());
    }
    let along = |axis: usize| order.iter().map(move |&it| boxes[it].center()[axis]);
    let least = |axis: usize| along(axis).fold(f64::INFINITY, f64::min);
    let most = |axis: usize| along(axis).fold(f64::NEG_INFINITY, f64::max);
    let size = [0, 1, 2].map(|axis| most(axis) - least(axis));
    let mut axis = 0;
    for other in [1, 2] {
        if size[other] > size[axis] {
            axis = other;
        }
    }
    let split = (least(axis) + most(axis)) / 2.0;
    order.sort_by(|&a, &b| boxes[a].center()[axis].total_cmp(&boxes[b].center()[axis]));
    let place = match order.partition_point(|&it| boxes[it].center()[axis] < split) {
        0 => order.len() / 2,
        all if all == order.len() => all / 2,
        place => place,
    };
    let (a, b) = order.split_at_mut(place);
    Tree::Branch(Box::new([subtree(boxes, a), subtree(boxes, b)]))
}
