use pinhole::{Hit, Node, RayTree};

pub fn nearest_hit(tree: &dyn RayTree, min_t: f64) -> Option<Hit> {
    let mut found = None;
    let root = tree.enter_box(0, min_t, f64::INFINITY)?;
    visit(tree, 0, root, min_t, &mut found);
    found
}

fn visit(tree: &dyn RayTree, node: usize, entry: f64, min_t: f64, found: &mut Option<Hit>) {
    let max_t = found.map_or(f64::INFINITY, |hit| hit.intersection.t);
    if entry > max_t {
        return;
    }
    match tree.node(node) {
        Node::Leaf(triangles) => {
            for &object in triangles {
                if let Some(intersection) = tree.intersect_triangle(object, min_t) {
                    *found = Some(Hit {
                        object,
                        intersection,
                    });
                }
            }
        }
        Node::Branch(children) => {
            let mut entered: Vec<(f64, usize)> = children
                .into_iter()
                .filter_map(|child| Some((tree.enter_box(child, min_t, max_t)?, child)))
                .collect();
            entered.sort_by(|a, b| a.0.total_cmp(&b.0));
            for (t, child) in entered {
                visit(tree, child, t, min_t, found);
            }
        }
    }
}
