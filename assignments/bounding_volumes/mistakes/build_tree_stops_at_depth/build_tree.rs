use pinhole::{BoundingBox, Tree};

const DEEPEST: usize = 3;

pub fn build_tree(boxes: &[BoundingBox]) -> Tree {
    grow(boxes, (0..boxes.len()).collect(), 0)
}

fn grow(boxes: &[BoundingBox], mut triangles: Vec<usize>, depth: usize) -> Tree {
    if triangles.len() <= 4 || depth == DEEPEST {
        return Tree::Leaf(triangles);
    }
    let center = |triangle: usize| boxes[triangle].center();
    let mut low = center(triangles[0]);
    let mut high = low;
    for &triangle in &triangles {
        low = low.min(center(triangle));
        high = high.max(center(triangle));
    }
    let axis = (high - low).max_position();
    let middle = 0.5 * (low[axis] + high[axis]);
    triangles.sort_by(|&a, &b| center(a)[axis].total_cmp(&center(b)[axis]));
    let mut first = triangles.partition_point(|&triangle| center(triangle)[axis] < middle);
    if first == 0 || first == triangles.len() {
        first = triangles.len() / 2;
    }
    let rest = triangles.split_off(first);
    let left = grow(boxes, triangles, depth + 1);
    let right = grow(boxes, rest, depth + 1);
    Tree::Branch(Box::new([left, right]))
}
