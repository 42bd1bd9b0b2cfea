use pinhole::{BoundingBox, Tree};

pub fn build_tree(boxes: &[BoundingBox]) -> Tree {
    grow(boxes, (0..boxes.len()).collect())
}

fn grow(boxes: &[BoundingBox], mut triangles: Vec<usize>) -> Tree {
    if triangles.len() <= 4 {
        return Tree::Leaf(triangles);
    }
    let mut low = boxes[triangles[0]].center();
    let mut high = low;
    for &triangle in &triangles {
        low = low.min(boxes[triangle].center());
        high = high.max(boxes[triangle].center());
    }
    let axis = (high - low).max_position();
    let middle = 0.5 * (low[axis] + high[axis]);
    let along = |triangle: usize| boxes[triangle].center()[axis];
    triangles.sort_by(|&a, &b| along(a).total_cmp(&along(b)));
    let mut split = triangles.partition_point(|&triangle| along(triangle) < middle);
    if split == 0 || split >= triangles.len() - 1 {
        split = triangles.len() / 2;
    }
    let left = triangles[..=split].to_vec();
    let right = triangles[split..].to_vec();
    Tree::Branch(Box::new([grow(boxes, left), grow(boxes, right)]))
}
