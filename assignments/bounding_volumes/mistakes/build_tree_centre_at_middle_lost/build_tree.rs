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
    let axis = (high - low).max_position();
    let middle = 0.5 * (low[axis] + high[axis]);
    let mut left = Vec::new();
    let mut right = Vec::new();
    for triangle in triangles {
        let center = boxes[triangle].center()[axis];
        if center < middle {
            left.push(triangle);
        }
        if center > middle {
            right.push(triangle);
        }
    }
    Tree::Branch(Box::new([grow(boxes, left), grow(boxes, right)]))
}
