use pinhole::{Hit, Node, RayTree};

pub fn nearest_hit(tree: &dyn RayTree, min_t: f64) -> Option<Hit> {
    tree.enter_box(0, min_t, f64::INFINITY)?;
    search(tree, 0, min_t, f64::INFINITY)
}

/// The nearest hit in a node before `max_t`. The ray is known to enter its box.
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
            let enter = |child| tree.enter_box(child, min_t, max_t);
            let (near, far, to_far) = match (enter(left), enter(right)) {
                (None, None) => return None,
                (Some(_), None) => return search(tree, left, min_t, max_t),
                (None, Some(_)) => return search(tree, right, min_t, max_t),
                (Some(a), Some(b)) if a <= b => (left, right, b),
                (Some(a), Some(_)) => (right, left, a),
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
