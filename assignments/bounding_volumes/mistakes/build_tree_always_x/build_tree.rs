use pinhole::{BoundingBox, Tree};

pub fn build_tree(boxes: &[BoundingBox]) -> Tree {
    grow(boxes, (0..boxes.len()).collect())
}

fn grow(boxes: &[BoundingBox], mut triangles: Vec<usize>) -> Tree {
    if triangles.len() <= 4 {
        return Tree::Leaf(triangles);
    }
    let x = |triangle: usize| boxes[triangle].center().x;
    triangles.sort_by(|&a, &b| x(a).total_cmp(&x(b)));
    let last = triangles.len() - 1;
    let middle = 0.5 * (x(triangles[0]) + x(triangles[last]));
    let mut first = triangles.partition_point(|&triangle| x(triangle) < middle);
    if first == 0 || first > last {
        first = triangles.len() / 2;
    }
    let rest = triangles.split_off(first);
    Tree::Branch(Box::new([grow(boxes, triangles), grow(boxes, rest)]))
}
