use pinhole::{Hit, Node, RayTree};

pub fn nearest_hit(tree: &dyn RayTree, min_t: f64) -> Option<Hit> {
    tree.enter_box(0, min_t, f64::INFINITY)?;
    let mut node = 0;
    loop {
        match tree.node(node) {
            Node::Branch([left, right]) => {
                let to_left = tree.enter_box(left, min_t, f64::INFINITY);
                let to_right = tree.enter_box(right, min_t, f64::INFINITY);
                node = match (to_left, to_right) {
                    (Some(a), Some(b)) if b < a => right,
                    (Some(_), _) => left,
                    (None, Some(_)) => right,
                    (None, None) => return None,
                };
            }
            Node::Leaf(triangles) => {
                let hits = triangles.iter().filter_map(|&object| {
                    let intersection = tree.intersect_triangle(object, min_t)?;
                    Some(Hit {
                        object,
                        intersection,
                    })
                });
                return hits.min_by(|a, b| a.intersection.t.total_cmp(&b.intersection.t));
            }
        }
    }
}
