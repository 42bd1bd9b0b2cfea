use pinhole::{BoundingBox, Tree};

pub fn build_tree(boxes: &[BoundingBox]) -> Tree {
    grow(boxes, (0..boxes.len()).collect())
}

fn grow(boxes: &[BoundingBox], triangles: Vec<usize>) -> Tree {
    if triangles.len() <= 4 {
        return Tree::Leaf(triangles);
    }
    let mut low = boxes[triangles[0]].center();
    let mut high = low;
    for &triangle in &triangles {
        low = low.min(boxes[triangle].center());
        high = high.max(boxes[triangle].center());
    }
    let size = high - low;
    let axis = size.max_position();
    let middle = 0.5 * size[axis];
    let (mut left, mut right): (Vec<usize>, Vec<usize>) = triangles
        .into_iter()
        .partition(|&triangle| boxes[triangle].center()[axis] < middle);
    if left.is_empty() {
        left = right.drain(..right.len() / 2).collect();
    } else if right.is_empty() {
        right = left.split_off(left.len() / 2);
    }
    Tree::Branch(Box::new([grow(boxes, left), grow(boxes, right)]))
}
