use pinhole::{BoundingBox, Tree};

// ANCHOR: stub
/// A binary tree over triangles, whose boxes are given in the mesh's order.
///
/// A leaf holds at most 8 triangles, by their places in that list, counted from 0. Each
/// triangle is in exactly one leaf.
///
/// To split a list, find the axis along which its boxes' centres spread most, and cut in the
/// middle between the least and the greatest centre: one child gets the triangles whose
/// centre lies on one side of the cut, the other child gets the rest. If that leaves one
/// child without a triangle, halve the list instead. `boxes` is never empty.
///
/// Book: Building the tree.
pub fn build_tree(boxes: &[BoundingBox]) -> Tree {
    // ANCHOR: answer
    fn split(boxes: &[BoundingBox], mut triangles: Vec<usize>) -> Tree {
        if triangles.len() <= 4 {
            return Tree::Leaf(triangles);
        }
        let center = |triangle: usize| boxes[triangle].center();
        let (mut low, mut high) = (center(triangles[0]), center(triangles[0]));
        for &triangle in &triangles {
            low = low.min(center(triangle));
            high = high.max(center(triangle));
        }
        let axis = (high - low).max_position();
        let middle = 0.5 * (low + high)[axis];
        triangles.sort_by(|&a, &b| center(a)[axis].total_cmp(&center(b)[axis]));
        let mut first = triangles.partition_point(|&it| center(it)[axis] < middle);
        if first == 0 || first == triangles.len() {
            first = triangles.len() / 2;
        }
        let rest = triangles.split_off(first);
        Tree::Branch(Box::new([split(boxes, triangles), split(boxes, rest)]))
    }

    split(boxes, (0..boxes.len()).collect())
    // ANCHOR_END: answer
}
// ANCHOR_END: stub
