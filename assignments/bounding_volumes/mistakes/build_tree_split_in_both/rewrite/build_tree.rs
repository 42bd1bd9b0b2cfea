use pinhole::{BoundingBox, Tree};

pub fn build_tree(boxes: &[BoundingBox]) -> Tree {
    let mut order: Vec<usize> = (0..boxes.len()).collect();
    let last = boxes.len() - 1;
    subtree(boxes, &mut order, 0, last)
}

/// The tree over the places from `first` to `last`, both included.
fn subtree(boxes: &[BoundingBox], order: &mut Vec<usize>, first: usize, last: usize) -> Tree {
    if last - first < 4 {
        return Tree::Leaf(order[first..=last].to_vec());
    }
    let range = |axis: usize| {
        let mut ends = [f64::INFINITY, f64::NEG_INFINITY];
        for &it in &order[first..=last] {
            let value = boxes[it].center()[axis];
            ends = [ends[0].min(value), ends[1].max(value)];
        }
        ends
    };
    let longest = (0..3).map(|axis| (axis, range(axis))).reduce(|a, b| {
        let is_longer = b.1[1] - b.1[0] > a.1[1] - a.1[0];
        if is_longer { b } else { a }
    });
    let (axis, [least, most]) = longest.unwrap_or((0, range(0)));
    let key = |it: &usize| boxes[*it].center()[axis];
    order[first..=last].sort_by(|a, b| key(a).total_cmp(&key(b)));
    let below = |it: &&usize| key(it) < (least + most) / 2.0;
    let mut split = first + order[first..=last].iter().filter(below).count();
    if split == first || split >= last {
        split = first + (last + 1 - first) / 2;
    }
    // The first child sorts its part again, but the second starts with the same triangle.
    let shared = order[split];
    let left = subtree(boxes, order, first, split);
    let place = order.iter().position(|&it| it == shared).unwrap_or(split);
    order.swap(place, split);
    Tree::Branch(Box::new([left, subtree(boxes, order, split, last)]))
}
