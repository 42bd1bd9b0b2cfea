use pinhole::{Hit, Node, RayTree};

pub fn nearest_hit(tree: &dyn RayTree, min_t: f64) -> Option<Hit> {
    let mut hits: Vec<Hit> = Vec::new();
    let mut stack = vec![0];
    while let Some(node) = stack.pop() {
        if tree.enter_box(node, min_t, f64::MAX).is_none() {
            continue;
        }
        match tree.node(node) {
            Node::Branch(children) => stack.extend(children),
            Node::Leaf(triangles) => hits.extend(triangles.iter().filter_map(|&object| {
                let intersection = tree.intersect_triangle(object, min_t)?;
                Some(Hit {
                    object,
                    intersection,
                })
            })),
        }
    }
    hits.sort_by(|a, b| a.intersection.t.total_cmp(&b.intersection.t));
    hits.first().copied()
}
