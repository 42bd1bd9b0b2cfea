use pinhole::{Hit, Node, RayTree};

pub fn nearest_hit(tree: &dyn RayTree, min_t: f64) -> Option<Hit> {
    let mut nearest = None;
    visit(tree, 0, min_t, &mut nearest);
    nearest
}

fn visit(tree: &dyn RayTree, node: usize, min_t: f64, nearest: &mut Option<Hit>) {
    let max_t = |nearest: &Option<Hit>| nearest.map_or(f64::INFINITY, |hit| hit.intersection.t);
    match tree.node(node) {
        Node::Leaf(triangles) => {
            for &object in triangles {
                if let Some(intersection) = tree.intersect_triangle(object, min_t)
                    && intersection.t < max_t(nearest)
                {
                    *nearest = Some(Hit {
                        object,
                        intersection,
                    });
                }
            }
        }
        Node::Branch(children) => {
            let mut entered = Vec::new();
            for child in children {
                if let Some(t) = tree.enter_box(child, min_t, max_t(nearest)) {
                    entered.push((t, child));
                }
            }
            entered.sort_by(|a, b| a.0.total_cmp(&b.0));
            for (t, child) in entered {
                if t <= max_t(nearest) {
                    visit(tree, child, min_t, nearest);
                }
            }
        }
    }
}
