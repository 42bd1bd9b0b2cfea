use pinhole::{BoundingBox, Tree};

pub fn build_tree(boxes: &[BoundingBox]) -> Tree {
    let mut order: Vec<usize> = (0..boxes.len()).collect();
    subtree(boxes, &mut order)
}

fn subtree(boxes: &[BoundingBox], order: &mut [usize]) -> Tree {
    match find_split(boxes, order) {
        Some(place) if order.len() > 4 => {
            let (first, second) = order.split_at_mut(place);
            Tree::Branch(Box::new([subtree(boxes, first), subtree(boxes, second)]))
        }
        _ => Tree::Leaf(order.to_vec()),
    }
}

/// Sorts the list along its longest axis, and finds the place to split it, if there is one.
fn find_split(boxes: &[BoundingBox], order: &mut [usize]) -> Option<usize> {
    let centers = || order.iter().map(|&it| boxes[it].center());
    let low = centers().reduce(|a, b| a.min(b))?;
    let high = centers().reduce(|a, b| a.max(b))?;
    let axis = (high - low).max_position();
    if low[axis] == high[axis] {
        return None;
    }
    let along = |it: usize| boxes[it].center()[axis];
    order.sort_by(|&a, &b| along(a).total_cmp(&along(b)));
    Some(order.partition_point(|&it| 2.0 * along(it) < low[axis] + high[axis]))
}
