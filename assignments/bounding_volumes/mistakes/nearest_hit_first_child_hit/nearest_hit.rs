use pinhole::{Hit, Node, RayTree};

pub fn nearest_hit(tree: &dyn RayTree, min_t: f64) -> Option<Hit> {
    search(tree, 0, min_t)
}

fn search(tree: &dyn RayTree, node: usize, min_t: f64) -> Option<Hit> {
    tree.enter_box(node, min_t, f64::INFINITY)?;
    match tree.node(node) {
        Node::Branch([left, right]) => {
            search(tree, left, min_t).or_else(|| search(tree, right, min_t))
        }
        Node::Leaf(triangles) => {
            let hits = triangles.iter().filter_map(|&object| {
                let intersection = tree.intersect_triangle(object, min_t)?;
                Some(Hit {
                    object,
                    intersection,
                })
            });
            hits.min_by(|a, b| a.intersection.t.total_cmp(&b.intersection.t))
        }
    }
}
