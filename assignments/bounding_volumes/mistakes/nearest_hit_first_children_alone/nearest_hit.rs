use pinhole::{Hit, Node, RayTree};

pub fn nearest_hit(tree: &dyn RayTree, min_t: f64) -> Option<Hit> {
    let mut node = 0;
    tree.enter_box(node, min_t, f64::INFINITY)?;
    while let Node::Branch([first, _]) = tree.node(node) {
        tree.enter_box(first, min_t, f64::INFINITY)?;
        node = first;
    }
    let Node::Leaf(triangles) = tree.node(node) else {
        return None;
    };
    let hits = triangles.iter().filter_map(|&object| {
        let intersection = tree.intersect_triangle(object, min_t)?;
        Some(Hit {
            object,
            intersection,
        })
    });
    hits.min_by(|a, b| a.intersection.t.total_cmp(&b.intersection.t))
}
