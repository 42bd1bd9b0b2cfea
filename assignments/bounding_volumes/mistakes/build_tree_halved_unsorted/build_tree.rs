use pinhole::{BoundingBox, Tree};

pub fn build_tree(boxes: &[BoundingBox]) -> Tree {
    let all: Vec<usize> = (0..boxes.len()).collect();
    halve(&all)
}

fn halve(triangles: &[usize]) -> Tree {
    if triangles.len() <= 4 {
        return Tree::Leaf(triangles.to_vec());
    }
    let (left, right) = triangles.split_at(triangles.len() / 2);
    Tree::Branch(Box::new([halve(left), halve(right)]))
}
