use pinhole::{Hit, Node, RayTree};

pub fn nearest_hit(tree: &dyn RayTree, min_t: f64) -> Option<Hit> {
    tree.enter_box(0, min_t, f64::INFINITY)?;
    search(tree, 0, min_t, f64::INFINITY)
}

/// The nearest hit in a node before `max_t`.
fn search(tree: &dyn RayTree, node: usize, min_t: f64, max_t: f64) -> Option<Hit> {
    match tree.node(node) {
        Node::Leaf(triangles) => {
            let hits = triangles.iter().filter_map(|&object| {
                let intersection = tree.intersect_triangle(object, min_t)?;
                Some(Hit {
                    object,
                    intersection,
                })
            });
            hits.filter(|hit| hit.intersection.t < max_t)
                .min_by(|a, b| a.intersection.t.total_cmp(&b.intersection.t))
        }
        Node::Branch([left, right]) => {
            let to_left = tree.enter_box(left, min_t, max_t)?;
            let to_right = tree.enter_box(right, min_t, max_t)?;
            let (near, far, to_far) = if to_left < to_right {
                (left, right, to_right)
            } else {
                (right, left, to_left)
            };
            let first = search(tree, near, min_t, max_t);
            let bound = first.map_or(max_t, |hit| hit.intersection.t);
            if to_far > bound {
                return first;
            }
            search(tree, far, min_t, bound).or(first)
        }
    }
}
