use pinhole::{BoundingBox, Tree};

pub fn build_tree(boxes: &[BoundingBox]) -> Tree {
    subtree(boxes, &Vec::from_iter(0..boxes.len()))
}

fn subtree(boxes: &[BoundingBox], part: &[usize]) -> Tree {
    if part.len() < 5 {
        return Tree::Leaf(part.to_vec());
    }
    let (axis, split) = plane(boxes, part);
    let mut order = part.to_vec();
    let [below, across, above] = sort_out(boxes, part, axis, split);
    let sides = [[below, across.clone()].concat(), [across, above].concat()];
    let longest = sides[0].len().max(sides[1].len());
    let total = sides[0].len() + sides[1].len();
    let children = match longest < part.len() && total <= part.len() * 3 / 2 {
        true => sides,
        false => {
            let rest = order.split_off(order.len() / 2);
            [order, rest]
        }
    };
    Tree::Branch(Box::new(children.map(|side| subtree(boxes, &side))))
}

/// The boxes below a plane, across it, and above it.
fn sort_out(boxes: &[BoundingBox], part: &[usize], axis: usize, split: f64) -> [Vec<usize>; 3] {
    let mut groups = [Vec::new(), Vec::new(), Vec::new()];
    for &it in part {
        let place = match (boxes[it].min[axis] < split, boxes[it].max[axis] < split) {
            (_, true) => 0,
            (true, false) => 1,
            (false, false) => 2,
        };
        groups[place].push(it);
    }
    groups
}

/// The longest axis of the centres, and its middle.
fn plane(boxes: &[BoundingBox], part: &[usize]) -> (usize, f64) {
    let centers = || part.iter().map(|&it| boxes[it].center());
    let first = boxes[part[0]].center();
    let low = centers().fold(first, |a, b| a.min(b));
    let high = centers().fold(first, |a, b| a.max(b));
    let axis = (high - low).max_position();
    (axis, (low[axis] + high[axis]) / 2.0)
}
