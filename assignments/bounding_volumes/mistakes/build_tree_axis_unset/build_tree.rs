use glam::DVec3;
use pinhole::{BoundingBox, Tree};

pub fn build_tree(boxes: &[BoundingBox]) -> Tree {
    grow(boxes, (0..boxes.len()).collect())
}

fn grow(boxes: &[BoundingBox], triangles: Vec<usize>) -> Tree {
    if triangles.len() <= 4 {
        return Tree::Leaf(triangles);
    }
    let mut low = DVec3::ZERO;
    let mut high = DVec3::ZERO;
    let size = high - low;
    let axis = if size.x > size.y && size.x > size.z {
        0
    } else if size.y > size.z {
        1
    } else {
        2
    };
    for (place, &triangle) in triangles.iter().enumerate() {
        let center = boxes[triangle].center();
        low = if place == 0 { center } else { low.min(center) };
        high = if place == 0 { center } else { high.max(center) };
    }
    let middle = 0.5 * (low[axis] + high[axis]);
    let (mut left, mut right): (Vec<usize>, Vec<usize>) = triangles
        .into_iter()
        .partition(|&triangle| boxes[triangle].center()[axis] < middle);
    if left.is_empty() {
        left = right.split_off(right.len() / 2);
    } else if right.is_empty() {
        right = left.split_off(left.len() / 2);
    }
    Tree::Branch(Box::new([grow(boxes, left), grow(boxes, right)]))
}
