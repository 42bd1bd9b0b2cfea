use pinhole::{BoundingBox, Tree};

pub fn build_tree(boxes: &[BoundingBox]) -> Tree {
    let mut order: Vec<usize> = (0..boxes.len()).collect();
    subtree(boxes, &mut order)
}

fn subtree(boxes: &[BoundingBox], order: &mut [usize]) -> Tree {
    if order.len() < 5 {
        return Tree::Leaf(order.to_vec());
    }
    let along = |axis: usize, it: usize| boxes[it].center()[axis];
    let range = |axis: usize| {
        let values = order.iter().map(|&it| along(axis, it));
        let (mut least, mut most) = (f64::INFINITY, f64::NEG_INFINITY);
        values.for_each(|value| (least, most) = (least.min(value), most.max(value)));
        (axis, least, most)
    };
    let ranges = [range(0), range(1), range(2)];
    let longest = ranges
        .into_iter()
        .max_by(|a, b| (a.2 - a.1).total_cmp(&(b.2 - b.1)));
    let (axis, least, most) = longest.unwrap_or(ranges[0]);
    let split = (least + most) / 2.0;
    order.sort_by(|&a, &b| along(axis, a).total_cmp(&along(axis, b)));
    let place = order.partition_point(|&it| along(axis, it) < split);
    let (first, second) = order.split_at_mut(place);
    Tree::Branch(Box::new([subtree(boxes, first), subtree(boxes, second)]))
}
